#!/bin/sh
# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# run_fuzzers.sh <folder of the fuzzers> [seconds] [at a time]
#
# Runs every fuzzer for some seconds from the corpus in tests/fuzz/corpus, as many at a time as there
# are cores, and prints a line of a Markdown table for each: wall and CPU seconds, executions, largest
# memory, result. What it finds stays in <folder>/found. Fails if a parser broke. A fuzzer whose log is
# in <folder> from a run of that length is not run again, so that the script can be interrupted.
set -eu

folder=$(realpath "$1")
seconds=${2:-60}
at_a_time=${3:-$(nproc)}
cd "$(dirname "$0")/.."
mkdir -p "$folder/found" "$folder/corpus"
# Freed memory is kept to catch its use; 256 MB of it, as usual, would count as the parser's.
export ASAN_OPTIONS="quarantine_size_mb=32${ASAN_OPTIONS:+:$ASAN_OPTIONS}"

ran() { grep -q "^Done .* in $((seconds + 1)) second" "$folder/$1.log" 2> /dev/null; }

run() {
  mkdir -p "$folder/corpus/$1"
  "$folder/fuzz_$1" -max_total_time="$seconds" -rss_limit_mb=512 -malloc_limit_mb=512 -timeout=10 \
    -max_len=65536 -print_final_stats=1 -artifact_prefix="$folder/found/$1-" \
    "$folder/corpus/$1" "tests/fuzz/corpus/$1" > "$folder/$1.log" 2>&1 || true
  times > "$folder/$1.times" # in a file, because in a pipe it would be another process's
}

# The CPU seconds of the child: the second line of `times`, "1m2.3s 0m4.5s".
cpu_seconds() {
  awk 'NR == 2 { split($1, a, /[ms]/); split($2, b, /[ms]/)
                 printf "%.0f", 60 * (a[1] + b[1]) + a[2] + b[2] }' "$folder/$1.times"
}

figure() { sed -n "s/^stat::$2: *//p" "$folder/$1.log"; }

names=$(for fuzzer in "$folder"/fuzz_*; do
  name=${fuzzer##*/fuzz_}
  if [ -d "tests/fuzz/corpus/$name" ]; then echo "$name"; fi
done)
running=0
for name in $names; do
  ran "$name" && continue
  run "$name" &
  running=$((running + 1))
  if [ "$running" -ge "$at_a_time" ]; then
    wait
    running=0
  fi
done
wait

status=0
echo '| parser | seconds | CPU seconds | executions | memory [MB] | result |'
echo '|---|---|---|---|---|---|'
for name in $names; do
  if ran "$name"; then result=clean; else result=BROKEN status=1; fi
  echo "| $name | $seconds | $(cpu_seconds "$name") | $(figure "$name" number_of_executed_units) |" \
    "$(figure "$name" peak_rss_mb) | $result |"
done
exit $status
