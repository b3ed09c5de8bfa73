#!/bin/sh
# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# run_consistency.sh [output file]
#
# Measures how well the information of registrations predicts their errors, on synthetic sequences, and
# writes docs/results/consistency.md. Recording takes about half an hour of CPU; the sequences are kept
# in build/consistency.
#
#   PROGRAM   (default build/release/cvo_slam)
#   BENCH     folder of the measuring program (default build/bench/bench)
set -eu

cd "$(dirname "$0")/.."
. bench/results_page.sh
program=${PROGRAM:-build/release/cvo_slam}
bench=${BENCH:-build/bench/bench}
page=${1:-docs/results/consistency.md}
folder=build/consistency
draft=$folder/consistency.md

require_program "$program" 'make build'
require_program "$bench/information_consistency" \
  'cmake --preset bench && cmake --build --preset bench --target information_consistency'
mkdir -p "$folder"

sequences=
# record <name> <world> <seed> <options of synth>
record() {
  sequences="$sequences $folder/$1"
  [ ! -d "$folder/$1" ] || return 0
  echo "run_consistency.sh: $1" >&2
  # shellcheck disable=SC2086  # several arguments
  "$program" synth "$2" "$folder/$1.part" --seed "$3" --noise kinect --image jpeg $4 > /dev/null 2>&1
  mv "$folder/$1.part" "$folder/$1"
}

for seed in 1 2 3 4 5; do record "room_$seed" room "$seed" '--frames 90'; done
for seed in 11 15; do record "office_$seed" office "$seed" '--frames 90'; done
record house_12 house 12 '--frames 90'
record room_13 room 13 '--frames 90'
record structure_texture_near_14 structure_texture_near 14 '--frames 90'
for seed in 201 204; do
  record "office_$seed" office "$seed" '--speed 2 --set sensor.exposure.time=0'
  record "house_$seed" house "$seed" '--speed 1.5'
done

{
  begin_page 'Consistency of the information' bench/run_consistency.sh \
    'What it means is in [the theory of tracking](../theory/tracking.md#information).'
  cat << 'END'

NEES = e^T Omega e of each frame against its keyframe, six degrees of freedom: the mean should be 6, and
95 % should be below 12.59. The factors were calibrated on the first five rows; sequences with the seeds
201 and 204 are whole paths, the others 90 frames.

END
  # shellcheck disable=SC2086  # several arguments
  "$bench/information_consistency" $sequences
} > "$draft"
mv "$draft" "$page"
echo "run_consistency.sh: wrote $page" >&2
