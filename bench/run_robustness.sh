#!/bin/sh
# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# run_robustness.sh [output file]
#
# Tracks synthetic worlds under all conditions and thinned real sequences, and writes
# docs/results/robustness.md (`make robustness`). An hour on two cores, most of it to record worlds and
# to wait for the baselines; what was measured of a revision is kept in build/robustness/<revision>, so
# that a second call goes on where the first was stopped. Remove that folder to measure again.
#
#   CVO_SLAM_DATA   folder of the recorded sequences (default: ../shared/data beside the checkout)
#   PROGRAM         (default build/release/cvo_slam)
#   SEEDS           of the eight kinds of structure and texture (default "101 102 103 104 105")
#   ROOM_SEEDS      of the rooms and their conditions, which take longer (default: SEEDS)
#   FRAMES          frames of each recording (default 60, two seconds)
#   SYSTEMS         of the study, see `cvo_slam bench odometry` (default ours,paper,rgbd,rgbd_icp,icp)
set -eu

cd "$(dirname "$0")/.."
. bench/results_page.sh
program=${PROGRAM:-build/release/cvo_slam}
page=${1:-docs/results/robustness.md}
data=${CVO_SLAM_DATA:-../shared/data}
seeds=${SEEDS-101 102 103 104 105}
room_seeds=${ROOM_SEEDS-$seeds}
frames=${FRAMES:-60}
systems=${SYSTEMS:-ours,paper,rgbd,rgbd_icp,icp}
folder=build/robustness/$(git describe --always)
# The names contain the process, so that several processes can share the work, by seeds.
sequence=$folder/sequence_$$
draft=$folder/robustness_$$.md
figures=docs/images/robustness
# The sensor is a Kinect without motion blur, which would take most of the time.
kinect='--noise kinect --set sensor.exposure.time=0'
rooms='room office house'
kinds='structure_texture_near structure_texture_far structure_notexture_near
  structure_notexture_far nostructure_texture_near nostructure_texture_far
  nostructure_notexture_near nostructure_notexture_far'

require_program "$program" 'make build'
mkdir -p "$folder" "$figures"

# record <world> <seed> <options of synth> makes the sequence that is tracked next.
record() {
  echo "run_robustness.sh: $*" >&2
  rm -rf "$sequence"
  # shellcheck disable=SC2086  # several arguments
  "$program" synth "$1" "$sequence" --frames "$frames" --seed "$2" --image jpeg $3 \
    > /dev/null 2>&1
}

is_measured() { [ -f "$folder/$1.rows" ]; }

# track <name> <sequence> <systems> <frames> [options] writes the rows of a table of `bench odometry` to
# <folder>/<name>.rows.
track() {
  # shellcheck disable=SC2086  # several arguments
  "$program" bench odometry "$2" --systems "$3" --frames "$4" --quiet ${5-} 2> /dev/null |
    grep -E '^\| (ours|paper|rgbd|rgbd_icp|icp) ' > "$folder/$1.part"
  mv "$folder/$1.part" "$folder/$1.rows"
}

# summary <name> <system> <mm> <deg> reads <name>_*.rows and prints the medians of a system's figures, and
# in how many runs no frame was lost and the RPE was within the two limits.
summary() {
  cat "$folder/$1"_[0-9]*.rows | awk -F '|' -v wanted="$2" -v mm="$3" -v deg="$4" '
    function median(list, n,   i, j, held) {
      for (i = 2; i <= n; ++i) {
        held = list[i]
        for (j = i - 1; j >= 1 && list[j] > held; --j) list[j + 1] = list[j]
        list[j + 1] = held
      }
      return n % 2 ? list[(n + 1) / 2] : (list[n / 2] + list[n / 2 + 1]) / 2
    }
    { gsub(/ /, "", $2) }
    $2 == wanted {
      ++n; t[n] = $3 + 0; r[n] = $4 + 0; a[n] = $7 ~ /-/ ? 1e9 : $7 + 0; lost += $8
      if ($8 + 0 == 0 && $3 + 0 <= mm && $4 + 0 <= deg) ++good
    }
    END {
      ate = median(a, n)
      printf "%.1f | %.2f | %s | %d | %d of %d", median(t, n), median(r, n),
        ate < 1e9 ? sprintf("%.1f", ate) : "-", lost, good, n
    }'
}

# better <shown name> <name> <systems> reads <name>_*.rows and prints a row for each system whose median
# RPE is lower than ours, or that loses fewer frames.
better() {
  ours=$(summary "$2" ours 0 0)
  for system in $(echo "$3" | tr ',' ' '); do
    [ "$system" != ours ] || continue
    printf '%s | %s\n' "$ours" "$(summary "$2" "$system" 0 0)" |
      awk -F ' [|] ' -v name="$1" -v other="$system" '
        $6 + 0 < $1 + 0 || $9 + 0 < $4 + 0 {
          printf "| %s | %s | %s | %d | %s | %d |\n", name, other, $6, $9, $1, $4
        }'
  done
}

each_system() { echo "$systems" | tr ',' ' '; }

# --- Measure -------------------------------------------------------------------------------------

# measure_room <world> <seed> tracks a room and its thinned versions, from one recording.
measure_room() {
  ! is_measured "every_3rd_$1_$2" || return 0
  record "$1" "$2" "$kinect"
  track "$1_$2" "$sequence" "$systems" :
  track "every_2nd_$1_$2" "$sequence" ours,rgbd ::2
  track "every_3rd_$1_$2" "$sequence" ours,rgbd ::3
}

# measure_kind <world> <seed> tracks one of the eight kinds, and draws the figure of the first seed.
measure_kind() {
  figure=
  [ "$2" != "${seeds%% *}" ] || [ -f "$figures/$1.svg" ] || figure="--plot $folder/figure"
  [ -n "$figure" ] || ! is_measured "$1_$2" || return 0
  record "$1" "$2" "$kinect"
  track "$1_$2" "$sequence" "$systems" : "$figure"
  [ -z "$figure" ] || mv "$folder/figure/odometry.svg" "$figures/$1.svg"
}

# measure_condition <condition> <world> <seed> <options of synth>
measure_condition() {
  ! is_measured "$1_$2_$3" || return 0
  record "$2" "$3" "$4"
  track "$1_$2_$3" "$sequence" ours,rgbd :
}

for seed in $seeds; do
  for world in $kinds; do
    measure_kind "$world" "$seed"
  done
done
for seed in $room_seeds; do
  for world in $rooms; do
    measure_room "$world" "$seed"
    measure_condition blur "$world" "$seed" '--noise kinect --set sensor.exposure.time=0.02'
    measure_condition exposure "$world" "$seed" \
      "$kinect --set sensor.exposure.jump=0.25 --set sensor.exposure.jump_interval=0.7"
    measure_condition missing "$world" "$seed" "$kinect --set sensor.depth.missing=0.3"
    measure_condition objects "$world" "$seed" "$kinect --set sensor.objects.count=3"
  done
done
rm -rf "$sequence"

for recording in tum/rgbd_dataset_freiburg1_rpy 7scenes/seq-01; do
  [ -d "$data/$recording" ] || continue
  for step in 1 2 3; do
    name=$(basename "$recording")_every_$step
    ! is_measured "$name" || continue
    echo "run_robustness.sh: $name" >&2
    track "$name" "$data/$recording" ours,rgbd "::$step"
  done
done

# --- Write ---------------------------------------------------------------------------------------

# shellcheck disable=SC2016  # Markdown's quotes
begin_page Robustness 'make robustness' 'Errors are RMSE as in [benchmarks](benchmarks.md). Where several
seeds were run, the numbers are their medians, and `lost` is the sum of the lost frames.' > "$draft"
cat >> "$draft" << END

## Structure and texture

The first $frames frames of each [synthetic world](../reference/synthetic-worlds.md), seeds $seeds
($room_seeds of room, office and house), recorded with \`$kinect\`
([sensor](../reference/synthetic-sensor.md)). A run is good if no frame is lost and the RPE over 1 s is at
most 100 mm and 3 deg. \`ours\` is the default tracker, \`paper\` is \`--preset paper\`, the others are
OpenCV's.

| world | system | RPE 1 s [mm] | RPE 1 s [deg] | ATE [mm] | lost | good |
| --- | --- | ---: | ---: | ---: | ---: | ---: |
END
for world in $rooms $kinds; do
  for system in $(each_system); do
    echo "| $world | $system | $(summary "$world" "$system" 100 3) |" >> "$draft"
  done
done

cat >> "$draft" << END

For each of the eight kinds, seed ${seeds%% *}: the distributions of the errors from frame to frame, and the
trajectories from above (figure (c) of the CVO paper).

END
for world in $kinds; do
  printf '**%s**\n\n![%s](../images/robustness/%s.svg)\n\n' "$world" "$world" "$world" >> "$draft"
done

cat >> "$draft" << END
## Where another system is better

Each case of this page in which another system has a lower median RPE over 1 s than ours, or loses
fewer frames. Without texture and structure nothing determines the pose: ours reports that it is lost, and
the systems that need no texture report a wrong pose.

| world or condition | system | RPE 1 s [mm] | lost | ours [mm] | ours lost |
| --- | --- | ---: | ---: | ---: | ---: |
END
for world in $rooms $kinds; do
  better "$world" "$world" "$systems" >> "$draft"
done
for condition in every_2nd every_3rd blur exposure missing objects; do
  for world in $rooms; do
    better "$condition, $world" "${condition}_$world" ours,rgbd >> "$draft"
  done
done

cat >> "$draft" << END

## Conditions

$(echo "$rooms" | sed 's/ /, /g') under one condition each, ours and RgbdOdometry. A run is good if no frame is lost and the RPE over 1 s is at most 30 mm and 1.5 deg.

- \`plain\`: as above.
- \`every_2nd\`, \`every_3rd\`: every second or third frame; the motion between frames is two or three times as
  large.
- \`blur\`: an exposure of 0.02 s. \`exposure\`: jumps of the exposure of 25 % about every 0.7 s.
- \`missing\`: 30 % of the depth pixels are missing, in patches. \`objects\`: three boxes that swing through the view.

| condition | world | system | RPE 1 s [mm] | RPE 1 s [deg] | ATE [mm] | lost | good |
| --- | --- | --- | ---: | ---: | ---: | ---: | ---: |
END
for condition in '' every_2nd_ every_3rd_ blur_ exposure_ missing_ objects_; do
  for world in $rooms; do
    for system in ours rgbd; do
      shown=${condition%_}
      echo "| ${shown:-plain} | $world | $system | $(summary "$condition$world" "$system" 30 1.5) |" \
        >> "$draft"
    done
  done
done

cat >> "$draft" << 'END'

## Large motion: real sequences thinned

Every n-th frame of the sequence; a frame is then n times as far from the one before. One run each:
a run gives the same bytes each time.

| sequence | n | system | RPE 1 s [mm] | RPE 1 s [deg] | ATE [mm] | lost |
| --- | ---: | --- | ---: | ---: | ---: | ---: |
END
for recording in rgbd_dataset_freiburg1_rpy seq-01; do
  for step in 1 2 3; do
    [ -f "$folder/${recording}_every_$step.rows" ] || continue
    awk -F '|' -v recording="$recording" -v step="$step" '{
      for (i = 2; i <= 8; ++i) gsub(/ /, "", $i)
      printf "| %s | %d | %s | %s | %s | %s | %s |\n", recording, step, $2, $3, $4, $7, $8
    }' "$folder/${recording}_every_$step.rows" >> "$draft"
  done
done
mv "$draft" "$page"
