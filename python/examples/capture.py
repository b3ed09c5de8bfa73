# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
"""capture.py <camera.yaml>: tracks a camera that OpenCV can read (OpenNI 2) until Ctrl-C."""

import sys
import time

import cv2  # Debian: python3-opencv

import cvo_slam

device = cv2.VideoCapture(cv2.CAP_OPENNI2)
device.set(cv2.CAP_OPENNI_DEPTH_GENERATOR_REGISTRATION, 1)  # depth as the colour camera sees it
slam = cvo_slam.Slam(cvo_slam.Camera.read(sys.argv[1]))  # depth_scale: 1000, OpenNI has millimetres
try:
    while device.grab():
        stamp = time.time()
        _, depth = device.retrieve(flag=cv2.CAP_OPENNI_DEPTH_MAP)
        _, bgr = device.retrieve(flag=cv2.CAP_OPENNI_BGR_IMAGE)
        record = slam.track(bgr[:, :, ::-1], depth, stamp)
        print(record.T_world_camera[:3, 3] if record.tracked else f"lost: {record.reason}")
except KeyboardInterrupt:
    pass  # between two frames: the map is whole
device.release()
slam.finish()
slam.trajectory().write("trajectory.txt")
