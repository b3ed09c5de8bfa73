#!/bin/sh
# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# run_keyframe_cost.sh [output file]
#
# Measures what adding a keyframe costs while the map grows, and writes docs/results/keyframe-cost.md.
# Takes about ten minutes.
#
#   BENCH     folder of the measuring program (default build/bench/bench)
set -eu

cd "$(dirname "$0")/.."
. bench/results_page.sh
bench=${BENCH:-build/bench/bench}
page=${1:-docs/results/keyframe-cost.md}

require_program "$bench/keyframe_cost" \
  'cmake --preset bench && cmake --build --preset bench --target keyframe_cost'
draft=$(mktemp)

{
  begin_page 'Cost of a keyframe' bench/run_keyframe_cost.sh \
    'Keyframes of a camera that goes over a long wall row by row, so that each overlaps the ten before
and after it: what a keyframe costs cannot grow because more of them overlap. CPU time of those of
the last 90 keyframes before each size in which no solve fell; the solver: wall time, a keyframe.'
  cat << 'END'

Without place recognition: the graph, the search for near keyframes and their registration.

END
  "$bench/keyframe_cost" --no-loops
  cat << 'END'

With place recognition: features are extracted besides, and the query for common words visits all
keyframes that share a word with the newest one. That query is what grows.

END
  "$bench/keyframe_cost"
} > "$draft"
mv "$draft" "$page"
chmod 644 "$page"
echo "run_keyframe_cost.sh: wrote $page" >&2
