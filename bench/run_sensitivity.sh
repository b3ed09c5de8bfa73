#!/bin/sh
# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# run_sensitivity.sh [output file]
#
# Multiplies each default of the tracker by 0.7 and 1.4 and prints what that does on three sequences:
# the table of docs/tracking.md. Takes about ten minutes.
#
#   CVO_SLAM_DATA   folder of the recorded sequences (default: ../shared/data beside the checkout)
set -eu

cd "$(dirname "$0")/.."
program=build/release/cvo_slam
data=${CVO_SLAM_DATA:-../shared/data}
office=build/sensitivity/office
out=${1:-/dev/stdout}

[ -f "$office/rgb.txt" ] || "$program" synth office "$office" --frames 300 --seed 21 \
  --noise kinect --set sensor.exposure.time=0 --image jpeg > /dev/null 2>&1

# "RPE mm / deg, ATE mm, lost" of ours: dataset, frames, setting.
figures() {
  "$program" bench odometry "$1" --frames "$2" --systems ours --quiet ${3:+--set "$3"} 2> /dev/null |
    awk -F'|' '/^\| ours/ { gsub(/ /, ""); printf "%s / %s, %s, %s", $3, $4, $7, $8 }'
}

row() {
  printf '| %s | %s | %s | %s |\n' "$1" \
    "$(figures "$data/tum/rgbd_dataset_freiburg1_rpy" : "$2")" \
    "$(figures "$data/7scenes/seq-01" 0:500 "$2")" \
    "$(figures "$office" : "$2")"
}

{
  echo '| setting | fr1/rpy: RPE 1 s [mm / deg], ATE [mm], lost | 7-Scenes, 500 frames | office, Kinect noise, 300 frames |'
  echo '| --- | --- | --- | --- |'
  row defaults ''
  for setting in tracker.points=1050 tracker.points=2100 tracker.keyframe_points=4200 tracker.keyframe_points=8400 \
    expert.tracker.selection.min_gradient=2.8 expert.tracker.selection.min_gradient=5.6 \
    'tracker.registration.length_scales=[0.07,0.035,0.0175,0.0105]' \
    'tracker.registration.length_scales=[0.14,0.07,0.035,0.021]' \
    expert.tracker.registration.kernel.color_scale=42 expert.tracker.registration.kernel.color_scale=84 \
    expert.tracker.registration.kernel.gradient_scale=42 expert.tracker.registration.kernel.gradient_scale=84 \
    expert.tracker.registration.kernel.sparsification=0.0007 expert.tracker.registration.kernel.sparsification=0.0014 \
    expert.tracker.registration.coarser_share=0.35 expert.tracker.registration.coarser_share=0.7 \
    tracker.keyframe.min_overlap=0.56 tracker.keyframe.min_overlap=0.95 \
    tracker.keyframe.max_translation=0.14 tracker.keyframe.max_translation=0.28 \
    tracker.keyframe.max_rotation=0.175 tracker.keyframe.max_rotation=0.35 \
    tracker.selection.max_depth=4.2 tracker.selection.max_depth=8.4 \
    tracker.compensate_depth_delay=false tracker.compensate_rolling_shutter=false expert.tracker.recovery_scales=0 \
    expert.tracker.registration.kernel.color_kernel=linear; do
    row "\`$setting\`" "$setting"
  done
} > "$out"
