// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <opencv2/core.hpp>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/point_cloud.h"
#include "cvo_slam/core/rgbd_frame.h"
#include "cvo_slam/core/saved_state.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/frontend/point_selection.h"

namespace cvo_slam {

/// Returns the logarithm of the factor by which a frame shows its points brighter than its keyframe
/// shows them: the median over the points that both see, which have a pose. None if too few are
/// seen, or are neither too dark nor too bright. Pixels of the cloud are those of the frame.
[[nodiscard]] std::optional<double> log_brightness_ratio(
    const PointCloud& points, const RgbdFrame& frame, const RgbdFrame& keyframe,
    const SE3& T_keyframe_frame, const Camera& camera, const FieldOfView& field_of_view);

/// Follows a camera's exposure. Between one image and the next the camera moves little: if the
/// whole image becomes brighter or darker by nearly the same factor, and by much, then the exposure
/// (or the light) has jumped and the view has not changed. Slow changes, and what a jump was
/// estimated wrong by, show once a frame is registered: the same points are brighter than in the
/// keyframe.
class ExposureGain {
 public:
  /// Compares the next image, CV_8UC1 or CV_8UC3, with the last one. The gain is exactly 1 as long
  /// as there was no jump and no large change. An image of another size than the last one counts as
  /// no jump.
  Exposure update(const cv::Mat& image);
  /// Takes log_brightness_ratio() of the image that update() was given last. The gain is that of
  /// the keyframe times the ratio if it differs from that by more than the kernel allows for.
  Exposure observe(const Exposure& keyframe, double log_ratio);
  /// The image that update() was given last becomes a keyframe. If the gain has drifted from what
  /// was measured, it makes a small step towards that.
  Exposure start_keyframe();
  void exchange(SavedState& state) { state(log_gain_, log_measured_, last_); }

 private:
  /// Returns the jump from last_ to next_ as a logarithm; 0 if there is none.
  double jump();

  [[nodiscard]] Exposure exposure() const;

  double log_gain_ = 0;
  double log_measured_ = 0;
  std::vector<float> last_, next_;  // pixels of a grid
  std::vector<float> changes_;      // memory
};

}  // namespace cvo_slam
