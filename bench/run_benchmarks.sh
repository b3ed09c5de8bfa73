#!/bin/sh
# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# run_benchmarks.sh [output file]
#
# Compares ours with the CVO paper's protocol and OpenCV's odometries on full sequences and writes
# docs/benchmarks.md (`make eval`). Takes about ten minutes.
#
#   CVO_SLAM_DATA     folder of the recorded sequences (default: ../shared/data beside the checkout);
#                     one that is not there is left out, and the page says so
#   BENCH_ARGUMENTS   further arguments for `cvo_slam bench odometry`, e.g. "--frames 0:200"
set -eu

cd "$(dirname "$0")/.."
program=build/release/cvo_slam
page=${1:-docs/benchmarks.md}
data=${CVO_SLAM_DATA:-../shared/data}
arguments=${BENCH_ARGUMENTS:-}
room=build/eval/room
draft=build/eval/benchmarks.md

[ -x "$program" ] || {
  echo "run_benchmarks.sh: $program is not built; run 'make build' first" >&2
  exit 1
}

# The figures of one sequence, with the command that gives them: title, path as people write it, path
# on this machine, systems.
compare() {
  echo "run_benchmarks.sh: $1" >&2
  # shellcheck disable=SC2016  # Markdown's quotes
  printf '\n## %s\n\n```\ncvo_slam bench odometry %s --systems %s%s\n```\n\n' \
    "$1" "$2" "$4" "${arguments:+ $arguments}" >> "$draft"
  # shellcheck disable=SC2086  # several arguments
  "$program" bench odometry "$3" --systems "$4" $arguments >> "$draft"
}

# One of the recorded sequences, below the folder of data: title, folder, systems.
compare_recorded() {
  if [ -d "$data/$2" ]; then
    compare "$1" "\$CVO_SLAM_DATA/$2" "$data/$2" "$3"
  else
    printf '\n## %s\n\nNot on this machine.\n' "$1" >> "$draft"
  fi
}

describe_machine() {
  model=$(sed -n 's/^model name[^:]*: *//p' /proc/cpuinfo | head -n 1)
  revision=$(git describe --always --dirty 2> /dev/null || echo unknown)
  cat << END
- CPU: ${model:-unknown}, $(nproc) of them; one thread of one is used
- date: $(date -u +%Y-%m-%d)
- revision: $revision
- runs: one of each sequence. Errors do not depend on the run; CPU times are medians and means over
  the frames, and every frame is handed to all systems in turn
END
}

mkdir -p "$(dirname "$draft")"
cat > "$draft" << 'END'
# Benchmarks

Written by `make eval` (`bench/run_benchmarks.sh`); do not edit. Each sequence is read once, frame
by frame, and every decoded frame is handed to every system in the same process.

END
describe_machine >> "$draft"

opencv=rgbd,rgbd_icp,icp
compare_recorded "TUM RGB-D fr1/rpy" tum/rgbd_dataset_freiburg1_rpy "ours,paper,$opencv"
compare_recorded "7-Scenes seq-01" 7scenes/seq-01 "ours,paper,$opencv"
"$program" synth room "$room" >&2
compare "Synthetic room" "$room" "$room" "ours,paper,$opencv"

# Only a whole page takes the place of the last one.
mv "$draft" "$page"
echo "run_benchmarks.sh: wrote $page" >&2
