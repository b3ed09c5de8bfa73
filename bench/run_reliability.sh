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
set -eu

cd "$(dirname "$0")/.."
. bench/results_page.sh
page=${1:-docs/results/reliability.md}
revision=$(git rev-parse --short HEAD)
work=build/reliability/$revision
seconds=${FUZZ_SECONDS:-1200}
mkdir -p "$work"

# step <name> <command>...: its output goes to a log; the log is kept if it was run to its end.
step() {
  name=$1
  shift
  [ -f "$work/$name.log" ] && return
  "$@" > "$work/$name.part" 2>&1 || echo "exit code $?" >> "$work/$name.part"
  mv "$work/$name.part" "$work/$name.log"
}

build() {
  cmake --preset "$1" > "$work/$1-configure.log"
  cmake --build --preset "$1" --parallel "$(nproc)" > "$work/$1-build.log"
}

build asan
step asan ctest --preset asan --parallel "$(nproc)"
build tsan
step tsan ctest --preset tsan --parallel "$(nproc)" -R '^(slam|io|apps)\.'
build fuzz
step fuzz tools/run_fuzzers.sh build/fuzz/tests/fuzz "$seconds"

# The line of ctest that counts the tests, and the names of those that failed.
verdict() {
  sed -n 's/^\([0-9]*% tests passed.*\)/\1/p; s/^.*- \(.*\) (Failed)$/failed: \1/p' "$work/$1.log"
}

{
  begin_page 'Reliability' 'bench/run_reliability.sh' \
    'Sanitizers over the tests, and fuzzers over the parsers: no parser may do anything but answer or throw an error, in at most 512 MB and 10 s an input.'
  printf '\n| sanitizers | tests | result |\n|---|---|---|\n'
  printf '| address, undefined behaviour (`make asan`) | all | %s |\n' "$(verdict asan | tr '\n' ' ')"
  printf '| thread (`make tsan`) | slam, io, apps | %s |\n\n' "$(verdict tsan | tr '\n' ' ')"
  grep '^|' "$work/fuzz.log"
} > "$page.part"
mv "$page.part" "$page"
