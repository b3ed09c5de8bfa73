// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core/mat.hpp>

namespace cvo_slam {

/// Returns the standard deviation of the noise of an image, CV_8UC1, in its values; 0 if the image
/// is smaller than 10x10 pixels. It is computed with the operator N = [1 -2 1; -2 4 -2; 1 -2 1] of
/// J. Immerkaer, "Fast Noise Variance Estimation", Computer Vision and Image Understanding 64(2),
/// 1996, which is blind to slopes and to edges along its axes; its response to noise has six times
/// the deviation of the noise. The median over a grid takes the place of the mean, so that texture
/// counts only if it covers half of the image.
[[nodiscard]] double image_noise(const cv::Mat& grey);

}  // namespace cvo_slam
