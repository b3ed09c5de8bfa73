#!/bin/sh
# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Draws the pictures of docs/guide/pictures.md, of docs/guide/first-run.md and of the README: `make
# pictures`. It uses the sequence of `make demo`. The picture of the report needs Chromium.
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

# The files of `make demo`, small enough for a README.
demo=$(pwd)/build/pictures_demo
out=docs/images/demo
mkdir -p "$out"
"$program" run "$room" --quiet --out "$demo"
"$program" render "$demo" --size 800x450 --reference "$room/groundtruth.txt" -o "$out/map.jpg"
cp "$demo/trajectory.svg" "$out/trajectory.svg"
if command -v chromium > /dev/null; then
  chromium --headless=new --no-sandbox --disable-gpu --hide-scrollbars --window-size=1000,1240 \
    --screenshot="$(pwd)/$out/report.jpg" "file://$demo/report.html"
else
  echo "no chromium: $out/report.jpg stays as it is; on Debian: apt-get install chromium" >&2
fi
