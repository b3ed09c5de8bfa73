#!/bin/sh
# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# run_reliability.sh [output file]
#
# Runs all tests under the address and undefined-behaviour sanitizers, those of slam, io and apps under
# the thread sanitizer, and the fuzzers, and writes docs/results/reliability.md. A step that is done
# for this revision is not done again, so the script can be interrupted.
#
#   FUZZ_SECONDS   seconds of each fuzzer (default 1200)
#   FUZZERS_AT_A_TIME   (default: one a core)
#   STEPS          steps to do (default 'asan tsan fuzz'); the page says which were not done
set -eu

cd "$(dirname "$0")/.."
. bench/results_page.sh
page=${1:-docs/results/reliability.md}
revision=$(git rev-parse --short HEAD)
work=build/reliability/$revision
seconds=${FUZZ_SECONDS:-1200}
mkdir -p "$work"

# step <preset> <command>...: builds a preset and runs the command, whose output goes to a log; the log
# is kept if it was run to its end.
step() {
  preset=$1
  shift
  case " ${STEPS:-asan tsan fuzz} " in *" $preset "*) ;; *) return ;; esac
  [ -f "$work/$preset.log" ] && return
  cmake --preset "$preset" > "$work/$preset-configure.log"
  cmake --build --preset "$preset" --parallel "$(nproc)" > "$work/$preset-build.log"
  "$@" > "$work/$preset.part" 2>&1 || echo "exit code $?" >> "$work/$preset.part"
  mv "$work/$preset.part" "$work/$preset.log"
}

step asan ctest --preset asan --parallel "$(nproc)"
step tsan ctest --preset tsan --parallel "$(nproc)" -R '^(slam|io|apps)\.'
step fuzz tools/run_fuzzers.sh build/fuzz/tests/fuzz "$seconds" "${FUZZERS_AT_A_TIME:-$(nproc)}"

# The line of ctest that counts the tests, and the names of those that failed.
verdict() {
  [ -f "$work/$1.log" ] || { echo 'not run for this revision'; return; }
  sed -n 's/^\([0-9]*% tests passed.*\)/\1/p; s/^.*- \(.*\) (Failed)$/failed: \1/p' "$work/$1.log"
}

{
  begin_page 'Reliability' 'bench/run_reliability.sh' \
    'Sanitizers over the tests, and fuzzers over the parsers: no parser may do anything but answer or throw an error, in at most 512 MB and 10 s an input.'
  printf '\n| sanitizers | tests | result |\n|---|---|---|\n'
  printf '| address, undefined behaviour (`make asan`) | all | %s |\n' "$(verdict asan | tr '\n' ' ')"
  printf '| thread (`make tsan`) | slam, io, apps | %s |\n\n' "$(verdict tsan | tr '\n' ' ')"
  grep '^|' "$work/fuzz.log" || echo 'The fuzzers were not run for this revision.'
} > "$page.part"
mv "$page.part" "$page"
