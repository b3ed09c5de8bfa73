#!/bin/sh
# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# run_world_statistics.sh [output file]
#
# Compares the images of the synthetic worlds with real ones, measures how fast they are made, draws the
# pictures of docs/images/worlds, and writes docs/results/synthetic-images.md. Takes about ten minutes.
#
#   CVO_SLAM_DATA   folder of the recorded sequences (default: ../shared/data beside the checkout)
#   PROGRAM         (default build/release/cvo_slam)
#   BENCH           folder of the measuring program (default build/bench/bench)
set -eu

cd "$(dirname "$0")/.."
. bench/results_page.sh
program=${PROGRAM:-build/release/cvo_slam}
bench=${BENCH:-build/bench/bench}
page=${1:-docs/results/synthetic-images.md}
real=${CVO_SLAM_DATA:-../shared/data}/tum/rgbd_dataset_freiburg1_rpy
work=build/world_statistics
draft=$work/synthetic-images.md

require_program "$program" 'make build'
require_program "$bench/world_statistics" \
  'cmake --preset bench && cmake --build --preset bench --target world_statistics'
mkdir -p "$work"

{
  begin_page 'Synthetic images' bench/run_world_statistics.sh \
    'The worlds are described in [synthetic worlds](../reference/synthetic-worlds.md).'
  cat << 'END'

## Do they look like real images?

To an ORB detector and to our point selection, at 640x480, means over 24 frames evenly spread over each
sequence. The columns are shares of pixels [%] by gradient magnitude (Sobel) in grey levels a pixel, its
median, the mean brightness, ORB keypoints (of at most 1000), their median Harris response (times 10^6)
and the points that `select_points` finds (of at most 6000). The worlds are recorded by an ideal sensor.

END
  if [ -d "$real" ]; then
    "$bench/world_statistics" --frames 24 --pictures docs/images/worlds --real "$real"
  else
    "$bench/world_statistics" --frames 24 --pictures docs/images/worlds
  fi
  cat << 'END'

## How fast are they made?

Frames of 640x480 with an ideal sensor, as PNG; what `cvo_slam synth <world> <folder> --frames 40 --speed 10
--seed 3` prints, with start-up, on all processors.

END
  echo '| world | speed |'
  echo '|---|---|'
  for world in room office house structure_texture_near nostructure_texture_near \
    structure_notexture_far; do
    rm -rf "$work/sequence"
    echo "| $world | $("$program" synth "$world" "$work/sequence" --frames 40 --speed 10 --seed 3 \
      2> /dev/null | sed -n 's/.*(\(.*\))$/\1/p') |"
  done
} > "$draft"
mv "$draft" "$page"
echo "run_world_statistics.sh: wrote $page" >&2
