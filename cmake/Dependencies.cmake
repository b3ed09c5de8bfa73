# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# What the libraries link: the one list for this build and for cvo_slam-config.cmake, which asks an
# embedder's CMake for the same (Install.cmake). Each entry is the arguments of find_package().

set(CVO_SLAM_DEPENDENCIES
    "Eigen3"
    "fmt"
    "hwy"
    "OpenCV COMPONENTS core calib3d features2d imgproc imgcodecs"
    "TBB"
    "yaml-cpp")

# What the back-end links besides: embedders that name their components and not this one do without.
set(CVO_SLAM_BACKEND_DEPENDENCIES "Ceres")

foreach(DEPENDENCY IN LISTS CVO_SLAM_DEPENDENCIES CVO_SLAM_BACKEND_DEPENDENCIES)
  separate_arguments(ARGUMENTS UNIX_COMMAND "${DEPENDENCY}")
  find_package(${ARGUMENTS} REQUIRED)
endforeach()
