#!/bin/sh
# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# run_place_recognition.sh [output file]
#
# Measures how well places are recognised and loops are closed, and writes
# docs/results/place-recognition.md. Two to three hours of CPU, most of it to record the ten houses,
# which are kept in build/house.
#
#   CVO_SLAM_DATA   folder of the recorded sequences (default: ../shared/data beside the checkout)
#   SEEDS           of the houses (default "201 202 203 204 205"; the vocabulary was trained on others)
#   PRESETS         sensors of the houses (default "kinect harsh")
#   PROGRAM         (default build/release/cvo_slam)
#   BENCH           folder of the measuring programs (default build/bench/bench)
set -eu

cd "$(dirname "$0")/.."
. bench/results_page.sh
program=${PROGRAM:-build/release/cvo_slam}
bench=${BENCH:-build/bench/bench}
page=${1:-docs/results/place-recognition.md}
data=${CVO_SLAM_DATA:-../shared/data}
folder=build/house
draft=$folder/place-recognition.md

require_program "$program" 'make build'
for name in loop_quality kidnapped_camera interrupted_run closed_loops; do
  require_program "$bench/$name" "cmake --preset bench && cmake --build --preset bench --target $name"
done
mkdir -p "$folder"

# record <folder> <world> <options of synth>: records a sequence that is not there yet.
record() {
  sequence=$1
  world=$2
  shift 2
  [ ! -d "$sequence" ] || return 0
  echo "run_place_recognition.sh: $sequence" >&2
  "$program" synth "$world" "$sequence.part" --image jpeg "$@" > /dev/null 2>&1
  mv "$sequence.part" "$sequence"
}

# The whole walk. People would stand in the way of some seeds. The harsh camera has no motion blur,
# which would take most of the time.
record_house() {
  sharp=
  [ "$1" != harsh ] || sharp='--set sensor.exposure.time=0'
  # shellcheck disable=SC2086  # two arguments
  record "$folder/house_$1_$2" house --seed "$2" --speed 1.5 --noise "$1" \
    --set sensor.objects.count=0 $sharp
}

# Nothing but keyframes: the walk 15 times as fast, and the sensor's times with it.
record_keyframes() {
  record "$folder/house_$1" house --seed "$1" --speed 15 --noise kinect \
    --set sensor.exposure.time=0.000533 --set sensor.exposure.readout=0.00173 \
    --set sensor.exposure.drift_period=0.267 --set sensor.timing.depth_jitter=0.00073
}

sequences=
for preset in ${PRESETS:-kinect harsh}; do
  for seed in ${SEEDS:-201 202 203 204 205}; do
    record_house "$preset" "$seed"
    sequences="$sequences $folder/house_${preset}_$seed"
  done
done
for seed in 1 2 3 4 5; do record_keyframes "$seed"; done
record "$folder/office_201" office --seed 201 --speed 2 --noise kinect --set sensor.exposure.time=0
recorded=
for name in tum/rgbd_dataset_freiburg1_rpy 7scenes/seq-01; do
  [ ! -d "$data/$name" ] || recorded="$recorded $data/$name"
done

{
  begin_page 'Place recognition' bench/run_place_recognition.sh \
    'How it works is in [the theory of place recognition](../theory/place-recognition.md).'
  cat << 'END'

## Recognition alone

Before any graph, CVO or residual is asked. *Revisiting* keyframes share at least half of the view with
an older one outside the temporal exclusion of 15 keyframes; *correct* is within 5 cm and 3 degrees of the
truth. The houses hold a keyframe each half second; of 7-Scenes every 15th frame is taken.

```
END
  for seed in 1 2 3 4 5; do "$bench/loop_quality" "$folder/house_$seed" --step 1 | tail -n 1; done
  [ ! -d "$data/7scenes/seq-01" ] || "$bench/loop_quality" "$data/7scenes/seq-01" --step 15 | tail -n 1
  cat << 'END'
```

## Kidnapped cameras

A camera walks for three seconds (`--speed 2`, a Kinect's noise without blur), is carried in no time to
where it has been, a few centimetres and degrees off its path, for ten frames, then to where it has not
been (at most 2 % of the view is known), for twenty, and so on. It is found when a frame's pose is right
within 5 cm and 3 degrees, seen from the nearest keyframe of the walk.

END
  "$bench/kidnapped_camera" --worlds house --first-seed 301 --seeds 12
  echo
  "$bench/kidnapped_camera" --worlds office,room --first-seed 301 --seeds 3
  cat << 'END'

## Interrupted runs

Two seconds in the middle of a run are white, black or blurred beyond recognition; `--mode slam`.

END
  # shellcheck disable=SC2086  # several arguments
  "$bench/interrupted_run" $recorded "$folder/office_201" "$folder/house_kinect_201"
  cat << 'END'

## Whole runs

Runs of `--mode slam` through `house` (47 m at 1.1 m/s). *Correct* loops are within 5 cm and 3 degrees.
Revisiting keyframes that follow one another are one revisit; they are joined if an edge leads to one of
the older keyframes. The harsh camera is recorded without blur; its exposure jumps by up to a factor of
2.4 and its noise is 4 to 8 grey levels.

END
  # shellcheck disable=SC2086  # several arguments
  "$bench/closed_loops" $sequences
} > "$draft"
mv "$draft" "$page"
echo "run_place_recognition.sh: wrote $page" >&2
