#!/bin/sh
# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# run_doubt.sh [output file]
#
# Fits the tracker's doubt to recordings, thinned to lower frame rates, tests it on others, and writes
# docs/results/doubt.md. The coefficients that it prints belong into frontend/tracking_doubt.cc. Takes
# half an hour on two cores, and as long again where the worlds are not there yet.
#
#   BUILD           folder of the programs (default build/release)
#   WORLDS          folder of the synthetic recordings (default $BUILD/doubt)
#   CVO_SLAM_DATA   folder of the real recordings (default ../shared/data)
set -eu

cd "$(dirname "$0")/.."
. bench/results_page.sh
build=${BUILD:-build/release}
worlds=${WORLDS:-$build/doubt}
samples=$build/doubt/samples
data=${CVO_SLAM_DATA:-../shared/data}
page=${1:-docs/results/doubt.md}

require_program "$build/bench/doubt_samples" \
  'cmake --preset release -DCVO_SLAM_BUILD_BENCH=ON && cmake --build --preset release'
mkdir -p "$samples" "$worlds"

# record <name> <options of synth>: a world that is not there yet.
record() {
  name=$1
  shift
  [ -d "$worlds/$name" ] || "$build/cvo_slam" synth "$@" "$worlds/$name" --image jpeg > /dev/null 2>&1
}

# sample <name> <recording> <steps> <more>: without and with starts by features.
sample() {
  name=$1
  recording=$2
  steps=$3
  shift 3
  "$build/bench/doubt_samples" "$recording" --steps "$steps" "$@" > "$samples/$name.csv"
  "$build/bench/doubt_samples" "$recording" --steps "$steps" "$@" --features \
    >> "$samples/$name.csv"
}

for seed in 201 202; do
  record "house_kinect_$seed" house --seed "$seed" --speed 1.5 --noise kinect --set sensor.objects.count=0
  record "house_harsh_$seed" house --seed "$seed" --speed 1.5 --noise harsh \
    --set sensor.objects.count=0 --set sensor.exposure.time=0
done
record office_201 office --seed 201 --speed 2 --noise kinect --set sensor.exposure.time=0

(
  for name in house_kinect_201 house_harsh_201; do sample "$name" "$worlds/$name" 1,3,5,8,12; done
  sample office_201 "$worlds/office_201" 1,4,8,12
) &
(
  for name in house_kinect_202 house_harsh_202; do sample "$name" "$worlds/$name" 1,3,5,8,12; done
) &
sample rpy "$data/tum/rgbd_dataset_freiburg1_rpy" 1,2,3,4,5,6,8,12 --depth-offset -0.0186
sample 7scenes "$data/7scenes/seq-01" 1,6,15,30,45,60
wait

draft=$(mktemp)
{
  begin_page 'The doubt of a frame' bench/run_doubt.sh \
    'Each frame has a `doubt`: the probability that its pose relative to the keyframe is wrong by more than
5 cm or 3 degrees. It is a logistic model of the overlap, cos_theta as a share of the usual one, the
registration'"'"'s own uncertainty, the difference from the nearest prediction, the time since the last
frame, the best answer elsewhere from another start, and what features say. Every registration at the end
of a frame is a sample, also those that were refused, at full and lower frame rates (every 1st to 60th frame), without features and with them.'
  echo
  /usr/bin/python3 bench/fit_doubt.py \
    --fit "$samples/rpy.csv" "$samples/house_kinect_201.csv" "$samples/house_harsh_201.csv" \
    "$samples/office_201.csv" \
    --test "$samples/7scenes.csv" "$samples/house_kinect_202.csv" "$samples/house_harsh_202.csv"
} > "$draft"
mv "$draft" "$page"
chmod 644 "$page"
echo "run_doubt.sh: wrote $page" >&2
