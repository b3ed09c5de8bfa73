#!/bin/sh
# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# run_benchmarks.sh [output file]
#
# Runs all modes of the program and OpenCV's odometries on full sequences and writes
# docs/results/benchmarks.md (`make eval`). Takes about ten minutes.
#
#   SYSTEMS           of `cvo_slam bench odometry` (default ours,rgbd,rgbd_icp,icp); `paper`, the CVO
#                     paper's protocol, takes half an hour more
#   CVO_SLAM_DATA     folder of the recorded sequences (default: ../shared/data beside the checkout);
#                     one that is not there is left out, and the page says so
#   PROGRAM           (default build/release/cvo_slam)
#   BENCH_ARGUMENTS   further arguments for both commands, e.g. "--frames 0:200"
set -eu

cd "$(dirname "$0")/.."
. bench/results_page.sh
program=${PROGRAM:-build/release/cvo_slam}
page=${1:-docs/results/benchmarks.md}
data=${CVO_SLAM_DATA:-../shared/data}
arguments=${BENCH_ARGUMENTS:-}
systems=${SYSTEMS:-ours,rgbd,rgbd_icp,icp}
work=build/eval
room=$work/room
draft=$work/benchmarks.md

require_program "$program" 'make build'

# The command as people write it, in a code block.
print_command() {
  # shellcheck disable=SC2016  # Markdown's quotes
  printf '\n```\n%s%s\n```\n\n' "$1" "${arguments:+ $arguments}"
}

# One row of the table of modes: a mode, path of the sequence on this machine.
mode_row() {
  # shellcheck disable=SC2086  # several arguments
  "$program" run "$2" --mode "$1" --out "$work/run" --json --quiet $arguments > "$work/report.json" ||
    [ $? -eq 3 ] # many lost frames are a result too
  awk -f tools/json_lines.awk "$work/report.json" > "$work/figures"
  figure() { json_figure "$@" < "$work/figures"; }
  error=evaluation.rpe.error
  frames=$(figure frames.processed 1 %d)
  printf '| %s | %s | %s | %s | %s | %s | %s | %s | %s | %s | %s |\n' "$1" \
    "$(figure $error.translation_m.rmse 1000 %.1f s)" "$(figure $error.rotation_deg.rmse 1 %.2f s)" \
    "$(figure $error.translation_m.rmse 1000 %.1f frames)" \
    "$(figure $error.rotation_deg.rmse 1 %.2f frames)" \
    "$(figure evaluation.ate.translation_m.rmse 1000 %.1f)" "$(figure frames.lost 1 %d)" \
    "$(figure frames.keyframes 1 %d)" "$(figure graph.loop_edges 1 %d)" \
    "$(figure cost.cpu_s "$(echo "$frames" | awk '{ print 1000 / ($1 > 0 ? $1 : 1) }')" %.1f)" \
    "$(figure cost.peak_memory_mb 1 %.0f)"
}

# The figures of one sequence, with the commands that give them: title, path as people write it, path
# on this machine.
compare() {
  echo "run_benchmarks.sh: $1" >&2
  {
    printf '\n## %s\n' "$1"
    print_command "cvo_slam run $2 --mode odometry|graph|slam"
    echo '| mode | RPE 1 s [mm] | RPE 1 s [deg] | RPE 1 frame [mm] | RPE 1 frame [deg] | ATE [mm] | lost | keyframes | loop edges | CPU a frame, with decoding [ms] | memory [MB] |'
    echo '| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |'
    for mode in odometry graph slam; do mode_row "$mode" "$3"; done
    print_command "cvo_slam bench odometry $2 --systems $systems"
    # shellcheck disable=SC2086  # several arguments
    "$program" bench odometry "$3" --systems $systems $arguments
  } >> "$draft"
}

# One of the recorded sequences, below the folder of data: title, folder.
compare_recorded() {
  if [ -d "$data/$2" ]; then
    compare "$1" "\$CVO_SLAM_DATA/$2" "$data/$2"
  else
    printf '\n## %s\n\nNot on this machine.\n' "$1" >> "$draft"
  fi
}

mkdir -p "$work"
# shellcheck disable=SC2016  # Markdown's quotes
begin_page Benchmarks 'make eval' 'The first table of a sequence compares the modes of `cvo_slam run`.
For the second one the sequence is read once, frame by frame, and every decoded frame is handed to every
system in the same process, on one thread.' > "$draft"
cat >> "$draft" << 'END'
- runs: one of each. Errors do not depend on the run; the CPU times of the second table are medians and
  means over the frames. The CPU of the first table is that of all threads without files and pictures
END
compare_recorded 'TUM RGB-D fr1/rpy' tum/rgbd_dataset_freiburg1_rpy
compare_recorded '7-Scenes seq-01' 7scenes/seq-01
"$program" synth room "$room" >&2
compare 'Synthetic room' "$room" "$room"

# Only a whole page takes the place of the last one.
mv "$draft" "$page"
echo "run_benchmarks.sh: wrote $page" >&2
