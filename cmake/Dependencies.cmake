# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The packages that the libraries link: the one list for this build and for cvo_slam-config.cmake,
# which looks for the same packages in an embedder's project (Install.cmake). Each entry is the
# arguments of a find_package().

set(CVO_SLAM_DEPENDENCIES
    "Eigen3"
    "fmt"
    "hwy"
    "libjpeg-turbo CONFIG"
    "OpenCV COMPONENTS core calib3d features2d imgproc imgcodecs"
    "TBB"
    "ZLIB"
    "yaml-cpp")

# Packages of the back-end alone: embedders who do not name this component do not need them.
set(CVO_SLAM_BACKEND_DEPENDENCIES "Ceres")

foreach(DEPENDENCY IN LISTS CVO_SLAM_DEPENDENCIES CVO_SLAM_BACKEND_DEPENDENCIES)
  separate_arguments(ARGUMENTS UNIX_COMMAND "${DEPENDENCY}")
  find_package(${ARGUMENTS} REQUIRED)
endforeach()
