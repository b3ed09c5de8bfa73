#!/bin/sh
# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# run_soak.sh [output file]
#
# Plays recordings again and again as one long sequence, and writes docs/results/soak.md: what each
# pass adds to the map, to memory and to the time of a frame. Takes about half an hour on one core.
#
#   BUILD           folder of the programs (default build/release)
#   CVO_SLAM_DATA   folder of the recordings (default ../shared/data); 7-Scenes is left out where it is not
set -eu

cd "$(dirname "$0")/.."
. bench/results_page.sh
build=${BUILD:-build/release}
page=${1:-docs/results/soak.md}
scenes=${CVO_SLAM_DATA:-../shared/data}/7scenes/seq-01
office=$build/soak/office

require_program "$build/bench/soak" \
  'cmake --preset release -DCVO_SLAM_BUILD_BENCH=ON && cmake --build --preset release'
if [ ! -f "$office/groundtruth.txt" ]; then
  "$build/cvo_slam" synth office "$office" --noise kinect --laps 5 > /dev/null
fi
if [ ! -f "$office-small/groundtruth.txt" ]; then
  "$build/cvo_slam" synth office "$office-small" --noise kinect --size 160x120 > /dev/null
fi
draft=$(mktemp)

{
  begin_page 'Long runs' bench/run_soak.sh \
    'Recordings are played again and again as one long sequence. Keyframes and edges are those that the
map has after a pass; removed are those that it does without since the start (`culling`); allocated is
what the program has asked of the system and not given back, resident what it holds of it.'
  if [ -d "$scenes" ]; then
    cat << 'END'

## A room that the camera never leaves

The sequence of 7-Scenes, forwards and backwards in turn.

END
    "$build/bench/soak" --passes 10 "$scenes"
    cat << 'END'

The same without culling:

END
    "$build/bench/soak" --passes 10 --keep-all "$scenes"
    cat << 'END'

The same with at most 6 MB of keyframes (`--set culling.max_memory=6`):

END
    "$build/bench/soak" --passes 4 --max-memory 6 "$scenes"
  fi
  cat << 'END'

## Laps of an office

A synthetic office with the noise of a Kinect: five rounds with noise of their own, played six times.

END
  "$build/bench/soak" --cyclic --passes 6 "$office"
  cat << 'END'

100,000 frames of 160x120 pixels: one round of the office, 139 times.

END
  "$build/bench/soak" --cyclic --passes 139 --rows-every 20 "$office-small"
} > "$draft"
mv "$draft" "$page"
chmod 644 "$page"
echo "run_soak.sh: wrote $page" >&2
