// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "cvo_slam/render/color_scale_internal.h"

namespace cvo_slam::render {

ColorScale::ColorScale(const Scene& scene) {
  for (const Path& path : scene.paths) {
    for (const double value : path.values) {
      if (!std::isfinite(value)) continue;
      min_ = std::min(min_, value);
      max_ = std::max(max_, value);
    }
  }
  cv::Mat levels(1, 256, CV_8UC1);
  // The last tenth, a pale yellow, is lost on a light ground.
  for (int i = 0; i < levels.cols; ++i)
    levels.at<std::uint8_t>(0, i) = cv::saturate_cast<std::uint8_t>(0.9 * i);
  cv::Mat colors;
  cv::applyColorMap(levels, colors, cv::COLORMAP_PLASMA);
  for (int i = 0; i < colors.cols; ++i) {
    const auto& bgr = colors.at<cv::Vec3b>(0, i);
    table_[static_cast<std::size_t>(i)] = {bgr[2], bgr[1], bgr[0]};
  }
}

Color ColorScale::operator()(double value) const {
  if (!std::isfinite(value) || empty()) return kGrey;
  const double share = std::clamp((value - min_) / (max_ - min_), 0.0, 1.0);
  return table_[static_cast<std::size_t>(std::lround(share * 255))];
}

}  // namespace cvo_slam::render
