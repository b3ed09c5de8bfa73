#!/bin/sh
# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# run_house_loops.sh
#
# Records the house with its look-alike corridors, seen by two noisy cameras, and prints the table of
# whole runs of docs/loops.md. Five to ten minutes of CPU for each of the ten recordings, which are
# kept in build/house, and one for each run.
#
#   SEEDS     (default "201 202 203 204 205"; the vocabulary was trained on others)
#   PRESETS   (default "kinect harsh")
#   PROGRAM   (default build/release/cvo_slam)
#   JUDGE     (default build/bench/bench/closed_loops; `cmake --preset bench` makes it)
set -eu

cd "$(dirname "$0")/.."
program=${PROGRAM:-build/release/cvo_slam}
judge=${JUDGE:-build/bench/bench/closed_loops}
folder=build/house

mkdir -p "$folder"
sequences=
for preset in ${PRESETS:-kinect harsh}; do
  for seed in ${SEEDS:-201 202 203 204 205}; do
    sequence=$folder/house_${preset}_$seed
    if [ ! -d "$sequence" ]; then
      # Without people in the way, for whom some seeds have no room; harsh without motion blur, which
      # would take most of the time.
      sharp=
      [ "$preset" != harsh ] || sharp='--set sensor.exposure.time=0'
      # shellcheck disable=SC2086  # two arguments
      "$program" synth house "$sequence.part" --seed "$seed" --speed 1.5 --noise "$preset" \
        --set sensor.objects.count=0 $sharp --image jpeg > /dev/null 2>&1
      mv "$sequence.part" "$sequence"
    fi
    sequences="$sequences $sequence"
  done
done
# shellcheck disable=SC2086  # several arguments
"$judge" $sequences
