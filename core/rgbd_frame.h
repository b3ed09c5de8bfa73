// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

#include <opencv2/core/mat.hpp>

#include "cvo_slam/core/timestamp.h"

namespace cvo_slam {

/// An associated pair of a colour and a depth image.
struct RgbdFrame {
  std::size_t index = 0;  ///< position in its sequence, from 0
  Timestamp stamp;        ///< stamp of the colour image, to which the pose belongs
  Timestamp depth_stamp;  ///< as its camera says; see Camera::depth_offset
  cv::Mat color;          ///< CV_8UC3 (blue, green, red) or CV_8UC1
  cv::Mat
      depth;  ///< CV_16UC1, registered to `color`, Camera::depth_scale units per metre, 0 = none
  /// Why the images could not be read; empty if they could. The tracker reports kLost with it.
  std::string problem;
};

}  // namespace cvo_slam
