// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include <opencv2/core/mat.hpp>

#include "cvo_slam/plot/figure.h"

namespace cvo_slam {

/// What a text takes up on an image [px].
struct ImageTextExtent {
  int width = 0;
  int above = 0;      ///< the base line
  int below = 0;      ///< the base line
  int thickness = 0;  ///< of its strokes
};

/// Of a text with an em square of `size` [px].
[[nodiscard]] ImageTextExtent image_text_extent(std::string_view text, double size);

/// Draws a text on a CV_8UC3 image (blue, green, red) from the left end of its base line. The fonts
/// know ASCII: any other character becomes '?'. `boldness` is a factor of the strokes' thickness.
void draw_image_text(cv::Mat& image, cv::Point origin, std::string_view text, double size,
                     Color color, double boldness = 1);

}  // namespace cvo_slam
