#!/bin/sh
# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# run_reliability.sh [output file]
#
# Runs all tests under the address and undefined-behaviour sanitizers, those of slam, io and apps under
# the thread sanitizer, and the fuzzers, and writes docs/results/reliability.md. A step that was done
# for this revision is not done again, so the script can be interrupted; for a step that is not asked
# for, the page keeps what it gave last, with the revision that it was run on.
#
#   FUZZ_SECONDS   seconds of each fuzzer (default 1200)
#   FUZZERS_AT_A_TIME   (default: one a core)
#   STEPS          steps to do (default 'asan tsan fuzz')
set -eu

cd "$(dirname "$0")/.."
. bench/results_page.sh
page=${1:-docs/results/reliability.md}
revision=$(git describe --always)
work=build/reliability
seconds=${FUZZ_SECONDS:-1200}
at_a_time=${FUZZERS_AT_A_TIME:-$(nproc)}
mkdir -p "$work"

# step <preset> <targets> <command>...: builds targets of a preset and runs the command; its output and
# the revision are kept if it was run to its end.
step() {
  preset=$1 targets=$2
  shift 2
  case " ${STEPS:-asan tsan fuzz} " in *" $preset "*) ;; *) return 0 ;; esac
  [ "$(cat "$work/$preset.revision" 2> /dev/null)" = "$revision" ] && return 0
  cmake --preset "$preset" > "$work/$preset-configure.log"
  # shellcheck disable=SC2086
  cmake --build --preset "$preset" --parallel "$(nproc)" --target $targets > "$work/$preset-build.log"
  "$@" > "$work/$preset.part" 2>&1 || echo "exit code $?" >> "$work/$preset.part"
  mv "$work/$preset.part" "$work/$preset.log"
  echo "$revision" > "$work/$preset.revision"
}

step asan all ctest --preset asan --parallel "$(nproc)"
step tsan 'slam_test io_test apps_test cvo_slam' ctest --preset tsan --parallel "$(nproc)" -R '^(slam|io|apps)\.'
step fuzz fuzzers tools/run_fuzzers.sh build/fuzz/tests/fuzz "$seconds" "$at_a_time"

# The revision that a step was run on, and when.
run_on() {
  [ -f "$work/$1.log" ] || { echo '-'; return; }
  echo "$(cat "$work/$1.revision"), $(date -u -r "$work/$1.log" +%Y-%m-%d)"
}

# The line of ctest that counts the tests, and the names of those that failed.
verdict() {
  [ -f "$work/$1.log" ] || { echo 'not run'; return; }
  sed -n 's/^\([0-9]*% tests passed.*\)/\1/p; s/^.*- \(.*\) (Failed)$/failed: \1/p' "$work/$1.log"
}

{
  begin_page 'Reliability' 'bench/run_reliability.sh' \
    'Sanitizers over the tests, and fuzzers over the parsers: no parser may do anything but answer or throw an error, in at most 512 MB and 10 s an input.'
  printf '\n| sanitizers | tests | revision | result |\n|---|---|---|---|\n'
  printf '| address, undefined behaviour (`make asan`) | all | %s | %s |\n' \
    "$(run_on asan)" "$(verdict asan | tr '\n' ' ')"
  printf '| thread (`make tsan`) | slam, io, apps | %s | %s |\n\n' \
    "$(run_on tsan)" "$(verdict tsan | tr '\n' ' ')"
  printf 'Fuzzers, %s at a time: %s\n\n' "$at_a_time" "$(run_on fuzz)"
  grep '^|' "$work/fuzz.log" || true
} > "$page.part"
mv "$page.part" "$page"
