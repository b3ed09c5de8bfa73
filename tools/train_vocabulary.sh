#!/bin/sh
# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Makes the vocabulary that ships (config/vocabulary/README.md): train_vocabulary.sh <fr1/rpy> <out>
# The same bytes on every x86-64 machine with Debian 12, in five minutes on two idle cores.
set -eu
if [ $# -ne 2 ]; then
  echo "usage: $0 <folder of TUM's rgbd_dataset_freiburg1_rpy> <file to write>" >&2
  exit 2
fi
sources=
# Seeds of 900 and above are for training alone: tests and measurements use small ones.
for seed in 900 901 902 903; do
  sources="$sources synth:house:$seed synth:office:$seed synth:room:$seed"
done
# Word splitting is meant.
# shellcheck disable=SC2086
exec "${CVO_SLAM:-build/release/cvo_slam}" vocab train -o "$2" $sources \
  synth:structure_texture_near:900 synth:structure_texture_far:901 \
  synth:nostructure_texture_near:902 synth:nostructure_texture_far:903 "$1"
