#!/bin/sh
# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# run_robustness.sh [output file]
#
# Tracks every built-in world and thinned real sequences, and writes docs/robustness.md
# (`make robustness`).
#
#   CVO_SLAM_DATA   folder of the recorded sequences (default: ../shared/data beside the checkout)
#   FRAMES          frames of each world (default 150, five seconds)
#   SYSTEMS         what to run, see `cvo_slam bench odometry` (default ours,paper,rgbd,rgbd_icp,icp)
set -eu

cd "$(dirname "$0")/.."
program=build/release/cvo_slam
page=${1:-docs/robustness.md}
data=${CVO_SLAM_DATA:-../shared/data}
frames=${FRAMES:-150}
systems=${SYSTEMS:-ours,paper,rgbd,rgbd_icp,icp}
folder=build/robustness
draft=$folder/robustness.md
# A Kinect without motion blur, which would take most of the time.
sensor='--noise kinect --set sensor.exposure.time=0'
seed=100

mkdir -p "$folder"

# The rows of a table of `bench odometry`, with a first column of their own.
rows() {
  awk -v name="$1" '/^\| (system|---)/ { next } /^\| / { print "| " name " " $0 }' >> "$draft"
}

head_of_table() {
  cat >> "$draft" << 'END'

| sequence | system | RPE 1 s [mm] | RPE 1 s [deg] | RPE 1 frame [mm] | RPE 1 frame [deg] | ATE [mm] | lost | CPU median [ms] | CPU mean [ms] |
| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |
END
}

cat > "$draft" << END
# Robustness

Written by \`make robustness\` (\`bench/run_robustness.sh\`); do not edit. Errors are RMSE as in
[benchmarks.md](benchmarks.md); \`lost\` counts frames.

## Synthetic worlds with a Kinect's noise

The first $frames frames of each world ([worlds.md](worlds.md)), seed $seed, recorded with
\`$sensor\` ([sensor.md](sensor.md)). Synthetic only. One run each.
END
head_of_table
for world in room office house \
  structure_texture_near structure_texture_far structure_notexture_near structure_notexture_far \
  nostructure_texture_near nostructure_texture_far nostructure_notexture_near \
  nostructure_notexture_far; do
  echo "run_robustness.sh: $world" >&2
  # Recorded once; remove the folder to record again.
  # shellcheck disable=SC2086  # several arguments
  [ -f "$folder/$world/rgb.txt" ] || "$program" synth "$world" "$folder/$world" --frames "$frames" --seed "$seed" --image jpeg $sensor \
    > /dev/null 2>&1
  "$program" bench odometry "$folder/$world" --systems "$systems" --quiet 2> /dev/null | rows "$world"
done

cat >> "$draft" << 'END'

## Large motion: real sequences thinned

Every n-th frame of the sequence; a frame is then n times as far from the one before.
END
head_of_table
for sequence in tum/rgbd_dataset_freiburg1_rpy 7scenes/seq-01; do
  [ -d "$data/$sequence" ] || continue
  for step in 1 2 3; do
    echo "run_robustness.sh: $sequence, every $step" >&2
    "$program" bench odometry "$data/$sequence" --systems ours,rgbd --frames "0::$step" --quiet \
      2> /dev/null | rows "$(basename "$sequence"), 1 of $step"
  done
done
mv "$draft" "$page"
