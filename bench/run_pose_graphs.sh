#!/bin/sh
# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# run_pose_graphs.sh [output file]
#
# Optimises published pose graphs, compares the time with the usual formulation, adds false loops, and
# writes docs/results/pose-graphs.md. Takes about fifteen minutes.
#
#   CVO_SLAM_DATA   folder with pose_graphs/*.g2o (default: ../shared/data beside the checkout)
#   PROGRAM         (default build/release/cvo_slam)
#   BENCH           folder of the measuring programs (default build/bench/bench)
#   RUN, TRUTH      folder of a run of --mode slam and its groundtruth.txt, for false loops in its graph
set -eu

cd "$(dirname "$0")/.."
. bench/results_page.sh
program=${PROGRAM:-build/release/cvo_slam}
bench=${BENCH:-build/bench/bench}
page=${1:-docs/results/pose-graphs.md}
CVO_SLAM_DATA=$(realpath "${CVO_SLAM_DATA:-../shared/data}")
export CVO_SLAM_DATA
graphs=$CVO_SLAM_DATA/pose_graphs
work=build/pose_graphs
draft=$work/pose-graphs.md

require_program "$program" 'make build'
for name in pose_graph_bench false_loops; do
  require_program "$bench/$name" "cmake --preset bench && cmake --build --preset bench --target $name"
done
mkdir -p "$work"

# Cost before and after: graph, start.
costs() {
  "$program" optimize "$graphs/$1.g2o" "$work/out.g2o" --init "$2" --json > "$work/report.json"
  awk -f tools/json_lines.awk "$work/report.json" > "$work/figures"
  printf ' %s | %s |' "$(json_figure cost.before 1 %.3g < "$work/figures")" \
    "$(json_figure cost.after 1 %.8g < "$work/figures")"
}

optimum_row() {
  printf '| %s |%s%s %s |\n' "$1" "$(costs "$1" auto)" "$(costs "$1" identity)" "$2"
}

{
  begin_page 'Pose graphs' bench/run_pose_graphs.sh \
    'How it works is in [the theory of the pose graph](../theory/pose-graph.md).'
  cat << 'END'

## Optima

Half the weighted sum of squares at the given poses (of the file, or all at the identity) and at the
optimum found from there; the published optimum is in the last column.

| graph | file's poses | found | identity | found | published |
|---|---|---|---|---|---|
END
  optimum_row sphere2500 677.00849
  optimum_row parking-garage 0.63419317
  optimum_row smallGrid3D 512.69903
  cat << 'END'

## Time

The same graphs with the usual formulation (automatic derivatives, positions and quaternions as blocks of
their own, Ceres' default options) and with ours. The usual formulation stops at a relative decrease of
1e-6, ours at 1e-7.

```
END
  "$bench/pose_graph_bench" 2> /dev/null
  cat << 'END'
```

## False loops

False loops as a bag of words makes them: the measurement of a genuine loop between two nodes that have
nothing to do with one another. Shares are of the genuine loops; at most 20 iterations a solve.

Synthetic graph, 300 nodes, known poses, error against the truth:

END
  "$bench/false_loops"
  printf '\nsphere2500, error against the optimum without false loops (its diameter is about 100 m):\n\n'
  "$bench/false_loops" "$graphs/sphere2500.g2o"
  if [ -n "${RUN:-}" ]; then
    printf '\nThe graph of a run (%s), ATE of the keyframes against the ground truth:\n\n' "$RUN"
    "$bench/false_loops" "$RUN" "$TRUTH"
  fi
} > "$draft"
mv "$draft" "$page"
echo "run_pose_graphs.sh: wrote $page" >&2
