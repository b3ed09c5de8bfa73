#!/bin/sh
# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# run_fuzzers.sh <folder of the fuzzers> [seconds] [at a time]
#
# Runs every fuzzer for some seconds from the corpus in tests/fuzz/corpus, as many at a time as there
# are cores, and prints a line of a Markdown table for each: executions, largest memory, result. What
# it finds stays in <folder>/found. Fails if a parser broke.
set -eu

folder=$(realpath "$1")
seconds=${2:-60}
at_a_time=${3:-$(nproc)}
cd "$(dirname "$0")/.."
mkdir -p "$folder/found" "$folder/corpus"

one() {
  name=$1
  mkdir -p "$folder/corpus/$name"
  log=$folder/$name.log
  result=clean
  "$folder/fuzz_$name" -max_total_time="$seconds" -rss_limit_mb=512 -malloc_limit_mb=512 -timeout=10 \
    -max_len=65536 -print_final_stats=1 -artifact_prefix="$folder/found/$name-" \
    "$folder/corpus/$name" "tests/fuzz/corpus/$name" > "$log" 2>&1 || result=BROKEN
  # The second line of `times` is of the children; it is read from a file because a pipe would be
  # another child.
  times > "$log.times"
  cpu=$(awk 'NR == 2 { split($1, user, /[ms]/); split($2, system, /[ms]/)
                       printf "%.0f", 60 * (user[1] + system[1]) + user[2] + system[2] }' "$log.times")
  executions=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
  memory=$(sed -n 's/^stat::peak_rss_mb: *//p' "$log")
  echo "| $name | $seconds | $cpu | ${executions:-?} | ${memory:-?} | $result |"
  [ $result = clean ]
}

status=0
running=0
pids=
echo '| parser | seconds | CPU seconds | executions | memory [MB] | result |'
echo '|---|---|---|---|---|---|'
for fuzzer in "$folder"/fuzz_*; do
  name=${fuzzer##*/fuzz_}
  [ -d "tests/fuzz/corpus/$name" ] || continue
  one "$name" &
  pids="$pids $!"
  running=$((running + 1))
  if [ "$running" -ge "$at_a_time" ]; then
    for pid in $pids; do wait "$pid" || status=1; done
    pids=
    running=0
  fi
done
for pid in $pids; do wait "$pid" || status=1; done
exit $status
