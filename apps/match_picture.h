// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>

#include "cvo_slam/loop/loop_verifier.h"

namespace cvo_slam {

/// Two images side by side, with a line from each point to where the other image sees it. The
/// images are CV_8UC3 or CV_8UC1, of any size; in the place of an empty one there is a grey field.
/// A picture wider than `max_width` [px] is shrunk to it. CV_8UC3: blue, green, red.
[[nodiscard]] cv::Mat draw_matches(const cv::Mat& a, const cv::Mat& b,
                                   const std::vector<PixelPair>& pixels, int max_width);

}  // namespace cvo_slam
