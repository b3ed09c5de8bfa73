# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
"""track_sequence.py <recording>: writes trajectory.txt, and trajectory.png if matplotlib is there."""

import sys

import cvo_slam

data = cvo_slam.open_dataset(sys.argv[1])
slam = cvo_slam.Slam(data.camera)
for i in range(len(data)):
    record = slam.track(data.read(i))
    if not record.tracked:
        print(f"frame {i} is lost: {record.reason}")
slam.finish()
trajectory = slam.trajectory()
trajectory.write("trajectory.txt")
print(trajectory)
if len(data.reference) > 0:
    print(cvo_slam.ate(data.reference, trajectory))

try:
    from matplotlib.figure import Figure
except ImportError:
    print("no picture: matplotlib is not installed")
else:
    figure = Figure()
    axes = figure.add_subplot(xlabel="x [m]", ylabel="z [m]", aspect="equal")
    axes.plot(trajectory.positions[:, 0], trajectory.positions[:, 2])
    figure.savefig("trajectory.png")
