#!/bin/sh
# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# check_packages.sh [folder]
#
# Proves the Debian packages of `make packages`: installs them in a minimal Debian 12 (in a folder that
# is kept, or a temporary one) and follows the guide as a newcomer would: program, manual, completion,
# C++ with CMake and with pkg-config, Python. Needs root, debootstrap and about 3 GB of disk.
set -eu

checkout=$(cd "$(dirname "$0")/.." && pwd)
. "$checkout/tools/debian_root.sh"
make_root "$@"

rm -rf "$root/packages" "$root/example"
mkdir "$root/packages" "$root/example"
cp "$checkout"/build/package/packages/*.deb "$root/packages/"
cp "$checkout/apps/examples/own_images.cc" "$root/example/"
cat > "$root/example/CMakeLists.txt" << 'END'
cmake_minimum_required(VERSION 3.25)
project(example LANGUAGES CXX)
find_package(cvo_slam REQUIRED)
add_executable(own_images own_images.cc)
target_link_libraries(own_images cvo_slam::slam opencv_imgproc)
END
cat > "$root/example/own_images.py" << 'END'
import numpy as np
import cvo_slam

camera = cvo_slam.Camera(320, 240, 260, 260, 159.5, 119.5, depth_scale=1000)
slam = cvo_slam.Slam(camera)
wall = np.random.default_rng(1).integers(0, 256, (60, 120, 3), np.uint8).repeat(4, 0).repeat(4, 1)
for i in range(30):
    rgb = np.ascontiguousarray(wall[:, 2 * i : 2 * i + 320])
    record = slam.track(rgb, np.full((240, 320), 2000, np.uint16), i / 30)
slam.finish()
print(f"x = {record.T_world_camera[0, 3]:.3f} m")
END

# step <what> <expected text> <command>...
step() {
  echo "check_packages.sh: $1"
  expected=$2
  shift 2
  inside "$@" > "$root/log" 2>&1 || { cat "$root/log" >&2; exit 1; }
  grep -q -- "$expected" "$root/log" || {
    echo "check_packages.sh: '$expected' is not in the output:" >&2
    cat "$root/log" >&2
    exit 1
  }
}

step 'apt-get install cvo-slam' 'cvo-slam' \
  sh -c 'DEBIAN_FRONTEND=noninteractive apt-get install --yes --no-install-recommends /packages/cvo-slam_*.deb bash-completion'
step 'cvo_slam --version' '[0-9]' cvo_slam --version
step 'synth and run' 'ATE' sh -c 'cvo_slam synth room /tmp/room --frames 20 --size 160x120 && cvo_slam run /tmp/room --out /tmp/run --overwrite && ls /tmp/run/map.png'
step 'manual' 'CVO_SLAM RUN' grep 'CVO_SLAM RUN' /usr/share/man/man1/cvo_slam.1
step 'completion' 'odometry graph slam' bash -c \
  '. /usr/share/bash-completion/bash_completion; . /usr/share/bash-completion/completions/cvo_slam
   COMP_WORDS=(cvo_slam run --mode ""); COMP_CWORD=3; _cvo_slam; echo "${COMPREPLY[*]}"'
step 'apt-get install python3-cvo-slam' 'python3-cvo-slam' \
  sh -c 'DEBIAN_FRONTEND=noninteractive apt-get install --yes --no-install-recommends /packages/python3-cvo-slam_*.deb'
step 'Python' 'x = 0.44' python3 /example/own_images.py
step 'apt-get install libcvo-slam-dev' 'libcvo-slam-dev' \
  sh -c 'DEBIAN_FRONTEND=noninteractive apt-get install --yes --no-install-recommends /packages/libcvo-slam-dev_*.deb cmake make g++ pkg-config'
step 'C++ with CMake' 'x = 0.44' \
  sh -c 'cd /example && cmake -S . -B build && cmake --build build && build/own_images'
step 'C++ with pkg-config' 'x = 0.44' \
  sh -c 'cd /example && g++ -std=c++20 -O2 own_images.cc -o own $(pkg-config --cflags --libs cvo_slam) && ./own'
echo 'check_packages.sh: all done'
