#!/bin/sh
# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# run_sensitivity.sh [output file]
#
# Multiplies each default of the tracker by 0.7 and 1.4 and writes what that does on three sequences to
# docs/results/sensitivity.md. Takes about ten minutes.
#
#   PROGRAM         (default build/release/cvo_slam)
#   CVO_SLAM_DATA   folder of the recorded sequences (default: ../shared/data beside the checkout)
set -eu

cd "$(dirname "$0")/.."
. bench/results_page.sh
program=${PROGRAM:-build/release/cvo_slam}
data=${CVO_SLAM_DATA:-../shared/data}
office=build/sensitivity/office
page=${1:-docs/results/sensitivity.md}
draft=build/sensitivity/sensitivity.md

require_program "$program" 'make build'
mkdir -p build/sensitivity

[ -f "$office/rgb.txt" ] || "$program" synth office "$office" --frames 300 --seed 21 \
  --noise kinect --set sensor.exposure.time=0 --image jpeg > /dev/null 2>&1

# figures <dataset> <frames> <setting> prints "RPE mm / deg, ATE mm, lost" of our tracker.
figures() {
  "$program" bench odometry "$1" --frames "$2" --systems ours --quiet ${3:+--set "$3"} 2> /dev/null |
    awk -F'|' '/^\| ours/ { gsub(/ /, ""); printf "%s / %s, %s, %s", $3, $4, $7, $8 }'
}

# full_setting <setting> prints a setting of the tracker with its whole key, which begins with `expert.`
# if it is an expert's option.
full_setting() {
  for key in "tracker.$1" "expert.tracker.$1"; do
    "$program" run --dump-config --set "$key" > /dev/null 2>&1 || continue
    echo "$key"
    return
  done
  echo "run_sensitivity.sh: there is no option for '$1'" >&2
  return 1
}

row() {
  printf '| %s | %s | %s | %s |\n' "$1" \
    "$(figures "$data/tum/rgbd_dataset_freiburg1_rpy" : "$2")" \
    "$(figures "$data/7scenes/seq-01" 0:500 "$2")" \
    "$(figures "$office" : "$2")"
}

{
  # shellcheck disable=SC2016  # Markdown's quotes
  begin_page Sensitivity bench/run_sensitivity.sh \
    'Each default of the tracker times 0.7 and 1.4, and switches turned: RPE over 1 s [mm / deg], ATE [mm], lost
frames. Settings are below `tracker.`'
  printf '\n'
  echo '| setting | fr1/rpy: RPE 1 s [mm / deg], ATE [mm], lost | 7-Scenes, 500 frames | office, Kinect noise, 300 frames |'
  echo '| --- | --- | --- | --- |'
  row defaults ''
  for setting in points=1050 points=2100 keyframe_points=4200 keyframe_points=8400 \
    selection.min_gradient=2.8 selection.min_gradient=5.6 \
    'registration.length_scales=[0.07,0.035,0.0175,0.0105]' \
    'registration.length_scales=[0.14,0.07,0.035,0.021]' \
    registration.kernel.color_scale=42 registration.kernel.color_scale=84 \
    registration.kernel.gradient_scale=42 registration.kernel.gradient_scale=84 \
    registration.kernel.sparsification=0.0007 registration.kernel.sparsification=0.0014 \
    registration.coarser_share=0.35 registration.coarser_share=0.7 \
    keyframe.min_overlap=0.56 keyframe.min_overlap=0.95 \
    keyframe.max_translation=0.14 keyframe.max_translation=0.28 \
    keyframe.max_rotation=0.175 keyframe.max_rotation=0.35 \
    selection.max_depth=4.2 selection.max_depth=8.4 \
    compensate_depth_delay=false compensate_rolling_shutter=false recovery_scales=0 \
    registration.kernel.color_kernel=linear; do
    key=$(full_setting "$setting")
    row "\`$setting\`" "$key"
  done
} > "$draft"
mv "$draft" "$page"
echo "run_sensitivity.sh: wrote $page" >&2
