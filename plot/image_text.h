// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include <opencv2/core/mat.hpp>

#include "cvo_slam/plot/figure.h"

namespace cvo_slam {

/// The space that a text takes on an image [px].
struct ImageTextExtent {
  int width = 0;      ///< length of the text
  int above = 0;      ///< height above the base line
  int below = 0;      ///< height below the base line
  int thickness = 0;  ///< thickness of the strokes
};

/// Returns the extent of a text whose em square has the given size [px].
[[nodiscard]] ImageTextExtent image_text_extent(std::string_view text, double size);

/// Draws a text on a CV_8UC3 image (blue, green, red). `origin` is the left end of the base line,
/// `boldness` a factor on the thickness of the strokes. The fonts have ASCII only: any other
/// character becomes '?'.
void draw_image_text(cv::Mat& image, cv::Point origin, std::string_view text, double size,
                     Color color, double boldness = 1);

}  // namespace cvo_slam
