#!/bin/sh
# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# run_maps.sh
#
# Makes maps of fr1/rpy and 7-Scenes, and one of 500 keyframes, and writes what they take on disk and what
# reading them costs to docs/results/maps.md.
set -eu

cd "$(dirname "$0")/.."
. bench/results_page.sh
data=${CVO_SLAM_DATA:-../shared/data}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# row name recording [arguments of run]
row() {
  name=$1
  recording=$2
  shift 2
  build/release/cvo_slam run "$recording" --out "$work/run" --overwrite --save-map --quiet "$@" > /dev/null
  build/release/bench/read_map "$work/run/map" 31 | awk -v name="$name" '
    { value[$1] = $2 }
    END {
      printf "| %s | %d | %.1f | %.1f | %.1f | %.1f | %.1f |\n", name, value["keyframes"],
        value["bytes_per_keyframe"] / 1000, value["read_and_check_ms"], value["read_map_ms"],
        value["ratio"], value["slam_ms"]
    }'
}

{
  begin_page "Maps on disk" "make maps" "Medians of 31 rounds, CPU time."
  cat << 'TEXT'

`cvo_slam run --save-map` makes the maps, with their surface. Reading and checksumming all files of the folder
(CRC-32) is what `read_map` is compared with. `Slam(map)` prepares the camera and makes the words of the features
anew.

| recording | keyframes | kB a keyframe | read and check [ms] | read_map [ms] | ratio | Slam(map) [ms] |
|---|---:|---:|---:|---:|---:|---:|
TEXT
  row "fr1/rpy" "$data/tum/rgbd_dataset_freiburg1_rpy"
  row "fr1/rpy, every keyframe kept" "$data/tum/rgbd_dataset_freiburg1_rpy" --set culling.enabled=false
  row "7-Scenes" "$data/7scenes/seq-01"
  row "7-Scenes, a keyframe every centimetre" "$data/7scenes/seq-01" --set culling.enabled=false \
    --set tracker.keyframe.max_translation=0.01 --set tracker.keyframe.max_rotation=0.02
} > "$work/page"
mv "$work/page" docs/results/maps.md
