// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core/mat.hpp>

namespace cvo_slam {

/// The standard deviation of the noise of an image, CV_8UC1, in its values; 0 for one that is
/// smaller than 10x10. From the operator of J. Immerkaer, "Fast Noise Variance Estimation",
/// Computer Vision and Image Understanding 64(2), 1996, which answers neither to slopes nor to
/// edges along its axes: N = [1 -2 1; -2 4 -2; 1 -2 1], whose response to noise has six times its
/// deviation. The median over a grid in place of the mean, so that texture counts only where it
/// covers half of the image.
[[nodiscard]] double image_noise(const cv::Mat& grey);

}  // namespace cvo_slam
