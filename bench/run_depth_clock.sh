#!/bin/sh
# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# run_depth_clock.sh [output file]
#
# Measures the depth offset of worlds whose offset is known and of the real recordings, and writes
# docs/results/depth-clock.md. Recording takes ten minutes of CPU; the worlds are kept.
#
#   PROGRAM         (default build/release/cvo_slam)
#   WORLDS          folder of the worlds (default build/depth-clock)
#   CVO_SLAM_DATA   folder of the real recordings (default ../shared/data)
set -eu

cd "$(dirname "$0")/.."
. bench/results_page.sh
program=${PROGRAM:-build/release/cvo_slam}
worlds=${WORLDS:-build/depth-clock}
data=${CVO_SLAM_DATA:-../shared/data}
page=${1:-docs/results/depth-clock.md}
draft=$(mktemp)
trap 'rm -f "$draft"' EXIT

require_program "$program" 'make build'
mkdir -p "$worlds"

# measure <recording> <known offset>: a row of the table.
measure() {
  found=$("$program" info --check --depth-offset measure "$1" | sed -n 's/^clock *depth offset //p')
  echo "| $(basename "$1") | $2 | $found |" >> "$draft"
}

# world <name> <scene> <seed> <offset [s]> <the same in ms>
world() {
  if [ ! -d "$worlds/$1" ]; then
    echo "run_depth_clock.sh: $1" >&2
    "$program" synth "$2" "$worlds/$1.part" --seed "$3" --frames 300 --noise kinect --image jpeg \
      --set sensor.exposure.time=0 --set "sensor.timing.depth_offset=$4" > /dev/null 2>&1
    mv "$worlds/$1.part" "$worlds/$1"
  fi
  measure "$worlds/$1" "$5"
}

begin_page 'The clock between colour and depth' 'make depth-clock' \
  'What `cvo_slam info --check --depth-offset measure` finds; [how](../theory/depth-clock.md).' > "$draft"
cat >> "$draft" << 'END'

| recording | known offset [ms] | measured |
| --- | ---: | --- |
END
for seed in 51 53 55; do world "office_$seed" office "$seed" -0.020 -20; done
for seed in 52 54 56; do world "room_$seed" room "$seed" 0.012 +12; done
for seed in 57 58 59; do world "house_$seed" house "$seed" 0 0; done
[ ! -d "$data/7scenes/seq-01" ] || measure "$data/7scenes/seq-01" '0 (equal stamps)'
[ ! -d "$data/tum/rgbd_dataset_freiburg1_rpy" ] || measure "$data/tum/rgbd_dataset_freiburg1_rpy" '-'
cp "$draft" "$page"
chmod 644 "$page"
echo "run_depth_clock.sh: wrote $page" >&2
