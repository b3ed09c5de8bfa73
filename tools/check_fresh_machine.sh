#!/bin/sh
# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# check_fresh_machine.sh [folder] [make target]...
#
# Proves apt-packages.txt: makes a minimal Debian 12 with nothing but a compiler, CMake, make and
# git in a folder (default: a temporary one, removed at the end), clones the last commit of this
# checkout into it and runs the make targets (default: test demo) there, each with its time.
# To be run again when apt-packages.txt changes. Needs root, debootstrap and about 3 GB of disk;
# a folder that is named is kept, and used again next time with the packages it has by then.
set -eu

checkout=$(cd "$(dirname "$0")/.." && pwd)
. "$checkout/tools/debian_root.sh"
make_root "$@"
[ $# -eq 0 ] || shift
[ $# -gt 0 ] || set -- test demo
inside DEBIAN_FRONTEND=noninteractive \
  apt-get install --yes --quiet=2 --no-install-recommends g++ cmake make git ca-certificates

# A bundle, because the clone runs inside, where the checkout's own .git cannot be reached.
git -C "$checkout" bundle create --quiet "$root/cvo_slam.bundle" HEAD
rm -rf "$root/cvo_slam"
inside git clone --quiet /cvo_slam.bundle /cvo_slam

for target in "$@"; do
  started=$(date +%s)
  inside make -C /cvo_slam "$target"
  echo "check_fresh_machine.sh: make $target took $(($(date +%s) - started)) s"
done
