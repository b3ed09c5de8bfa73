# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
"""save_and_localize.py <recording> <map folder>: makes a map, and locates the same frames in it."""

import sys

import cvo_slam

data = cvo_slam.open_dataset(sys.argv[1])
slam = cvo_slam.Slam(data.camera)
for frame in data:
    slam.track(frame)
slam.finish()
slam.map().write(sys.argv[2])

# Tomorrow, in another process:
slam = cvo_slam.Slam(cvo_slam.Map.read(sys.argv[2]), localize=True)
located = sum(slam.track(frame).localized for frame in data)
print(f"{located} of {len(data)} frames located")
