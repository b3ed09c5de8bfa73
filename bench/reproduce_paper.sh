#!/bin/sh
# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Draws the CVO paper's three figures from a recorded sequence: `make reproduce-paper`. What they
# show is in docs/guide/paper-figures.md.
set -eu

program=${1:-build/release/cvo_slam}
sequence=${2:-${CVO_SLAM_DATA:-../shared/data}/tum/rgbd_dataset_freiburg1_rpy}
out=${3:-results/paper}

if [ ! -d "$sequence" ]; then
  echo "reproduce-paper: no sequence at $sequence; set CVO_SLAM_DATA to the folder that holds" \
    "tum/rgbd_dataset_freiburg1_rpy, or name another one with DATASET=path" >&2
  exit 1
fi

# (a) registration and (b) step; with frames a fifth of a second apart the motion is to be seen.
"$program" align "$sequence" "${FRAME_A:-300}" "${FRAME_B:-306}" --preset paper --plot "$out"
echo
# (c) odometry
"$program" bench odometry "$sequence" --frames "${FRAMES:-0:}" --plot "$out"
echo
echo "Figures:"
for figure in registration step odometry; do echo "  $out/$figure.png $out/$figure.svg"; done
