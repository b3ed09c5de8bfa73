# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
"""own_images.py: tracks images that are in memory; here of a wall that the camera passes.

With OpenCV, a grabbed image has blue first and becomes rgb = bgr[:, :, ::-1], which copies nothing.
"""

from typing import Iterator

import numpy as np

import cvo_slam

camera = cvo_slam.Camera(320, 240, 260, 260, 159.5, 119.5, depth_scale=1000, name="mine")


def grab() -> Iterator[tuple[float, np.ndarray, np.ndarray]]:  # type: ignore[type-arg]
    """Yields stamps [s], colour images and depth images [mm]: 2 px a frame along a wall at 2 m."""
    random = np.random.default_rng(0)
    wall = random.integers(0, 256, (60, 120, 3), np.uint8).repeat(4, axis=0).repeat(4, axis=1)
    depth = np.full((240, 320), 2000, np.uint16)
    for i in range(30):
        yield i / 30, wall[:, 2 * i : 2 * i + 320], depth


slam = cvo_slam.Slam(camera, cvo_slam.SlamOptions(tracker={"points": 1000}))
for stamp, rgb, depth in grab():
    record = slam.track(rgb, depth, stamp)
    if record.T_world_camera is None:
        print(f"lost: {record.reason}")
    else:
        print(f"{stamp:.3f} s: x = {record.T_world_camera[0, 3]:.3f} m")
slam.finish()
slam.trajectory().write("own_images.txt")
