# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
"""RGB-D SLAM with Continuous Visual Odometry.

    import cvo_slam
    data = cvo_slam.open_dataset(path)
    slam = cvo_slam.Slam(data.camera)
    for i in range(len(data)):
        slam.track(data.read(i))
    slam.finish()
    slam.trajectory().write("trajectory.txt")

Poses are numpy arrays of shape (4, 4): T_a_b maps points of frame b to frame a. Lengths are in
metres, times in seconds, angles in radians.
"""

from . import _cvo_slam
from ._cvo_slam import *  # noqa: F403  (the module is written in C++; __init__.pyi lists it)
from ._cvo_slam import __version__

__all__ = [name for name in dir(_cvo_slam) if not name.startswith("_")] + ["__version__"]

# What people see in messages and in help() is the name that they import.
for _name in __all__:
    _object = getattr(_cvo_slam, _name)
    if isinstance(_object, type):
        _object.__module__ = "cvo_slam"
del _name, _object
