// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Stands in for opencv_odometry.cc where OpenCV has no module rgbd.
#include "cvo_slam/apps/opencv_odometry.h"

namespace cvo_slam {

std::unique_ptr<OdometrySystem> make_opencv_odometry(OpencvMethod /*method*/,
                                                     const Camera& /*camera*/) {
  return nullptr;
}

}  // namespace cvo_slam
