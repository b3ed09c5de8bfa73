#!/bin/sh
# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Draws the pictures of docs/rendering.md: `make pictures`. Takes the sequence of `make demo`.
set -eu

program=${1:-build/release/cvo_slam}
room=${2:-build/demo/room}
run=build/pictures
out=docs/images/render
mkdir -p "$out"
"$program" run "$room" --mode graph --quiet --out "$run"

draw() {
  name=$1
  shift
  "$program" render "$run" --size 720x405 -o "$out/$name.jpg" "$@"
}
draw top --view top
draw front --view front
draw side --view side
draw iso --view iso
draw turntable --view turntable --azimuth 140
draw follow --view follow --at 0.15
draw error --view turntable --azimuth 70 --reference "$room/groundtruth.txt" --color error
