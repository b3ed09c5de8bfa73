# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# What the libraries link. cvo_slam-config.cmake.in asks the embedder's CMake for the same.
# CMake targets carry their include folders as system headers, so that -Wall is about our code.

find_package(Eigen3 REQUIRED)
find_package(fmt REQUIRED)
find_package(OpenCV REQUIRED COMPONENTS core imgproc imgcodecs)
find_package(TBB REQUIRED)
find_package(yaml-cpp REQUIRED)
find_package(hwy REQUIRED)
