// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "cvo_slam/apps/odometry_benchmark.h"

namespace cvo_slam {

enum class OpencvMethod {
  kRgbd,     ///< cv::rgbd::RgbdOdometry: photometric error (Steinbrücker et al., 2011)
  kRgbdIcp,  ///< cv::rgbd::RgbdICPOdometry: photometric and point-to-plane error
  kIcp,      ///< cv::rgbd::ICPOdometry: point-to-plane error (KinectFusion's)
};

/// Makes an odometry of OpenCV with its default options, each frame registered to the frame before
/// it. Images are undistorted first, because these methods know only a pinhole camera. On TUM
/// fr1/rpy this helps two of them and does not change the third (ATE raw and undistorted:
/// RgbdICPOdometry 54 and 51 mm, ICPOdometry 70 and 54 mm, RgbdOdometry 56 and 56 mm, with one and
/// two pairs lost). Returns null if OpenCV was built without its contrib module rgbd.
[[nodiscard]] std::unique_ptr<OdometrySystem> make_opencv_odometry(OpencvMethod method,
                                                                   const Camera& camera);

}  // namespace cvo_slam
