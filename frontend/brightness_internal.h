// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <opencv2/core.hpp>

namespace cvo_slam {

/// Follows the jumps of a camera's exposure. Between one image and the next the camera moves
/// little: where all of the image becomes brighter or darker by nearly the same factor, and by
/// much, it is the exposure (or the light) that has changed and not the view.
class BrightnessLevel {
 public:
  /// The next image, CV_8UC1 or CV_8UC3; of one of another size than the last nothing is said.
  void update(const cv::Mat& image);
  /// The factor by which the last image is brighter than the first one for reasons of exposure;
  /// exactly 1 as long as there was no jump.
  [[nodiscard]] double factor() const;

 private:
  /// The jump from last_ to next_ as a logarithm; 0 where there is none.
  double jump();

  double log_factor_ = 0;
  std::vector<float> last_, next_;  // pixels of a grid
  std::vector<float> changes_;      // memory
};

}  // namespace cvo_slam
