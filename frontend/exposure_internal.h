// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <opencv2/core.hpp>

namespace cvo_slam {

/// Follows the jumps of a camera's exposure. Between one image and the next the camera moves
/// little: if the whole image becomes brighter or darker by nearly the same factor, and by much,
/// then the exposure (or the light) has changed and not the view.
class ExposureGain {
 public:
  /// Compares the next image, CV_8UC1 or CV_8UC3, with the last one, and returns the factor by
  /// which it is brighter than the first image because of exposure: exactly 1 as long as there was
  /// no jump. An image of another size than the last one counts as no jump.
  double update(const cv::Mat& image);

 private:
  /// Returns the jump from last_ to next_ as a logarithm; 0 if there is none.
  double jump();

  double log_gain_ = 0;
  std::vector<float> last_, next_;  // pixels of a grid
  std::vector<float> changes_;      // memory
};

}  // namespace cvo_slam
