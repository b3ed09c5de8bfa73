// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What two frames of a moving camera say about the clock between colour and depth. The colours tell
// the motion between the colour images, the depths that between the depth images; where the
// camera's velocity has changed, the two differ by what the clock is off.
// docs/theory/depth-clock.md.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/rgbd_frame.h"
#include "cvo_slam/core/se3.h"

namespace cvo_slam {

/// A camera whose images are halved.
class ClockCamera {
 public:
  explicit ClockCamera(const Camera& camera);

  [[nodiscard]] const PinholeCamera& pinhole() const { return pinhole_; }
  [[nodiscard]] const SensorNoise& noise() const { return noise_; }
  /// Returns the point (x/z, y/z, 1) of a pixel.
  [[nodiscard]] const Vector3& ray(int u, int v) const {
    return rays_[static_cast<std::size_t>(v) * static_cast<std::size_t>(pinhole_.width) +
                 static_cast<std::size_t>(u)];
  }
  /// Returns the depth at a pixel [m]; 0 = none.
  [[nodiscard]] double depth_at(const cv::Mat& depth, int u, int v) const {
    return depth.at<std::uint16_t>(v, u) * metres_;
  }
  /// Returns the time at which a row was read, after the stamp [s].
  [[nodiscard]] double row_delay(double v) const {
    return row_time_ * (v - 0.5 * (pinhole_.height - 1));
  }
  [[nodiscard]] bool has_rolling_shutter() const { return row_time_ > 0; }

 private:
  PinholeCamera pinhole_;
  SensorNoise noise_;
  double metres_;
  double row_time_;  // [s]
  std::vector<Vector3> rays_;
};

/// A frame of half the size, with what is known of its time.
struct ClockFrame {
  cv::Mat grey;   ///< CV_8UC1, smoothed
  cv::Mat depth;  ///< CV_16UC1, depth units of the camera; 0 = none
  SE3 T_world_camera;
  Vector6 velocity;  ///< of the camera at the colour stamp, right tangent [m/s; rad/s]
  double delay = 0;  ///< from the colour to the depth image, as far as it is known [s]
};

/// Returns images of half the size; the other members are left as they are by default.
[[nodiscard]] ClockFrame make_clock_frame(const RgbdFrame& frame);

/// A correction x of the delay minimises S x^2 / 2 + s x, summed over all pairs.
struct ClockEvidence {
  double curvature = 0;  ///< S
  double slope = 0;      ///< s
};

/// Returns what a pair of frames says. Empty if the two have too little in common.
[[nodiscard]] std::optional<ClockEvidence> clock_evidence(const ClockFrame& fixed,
                                                          const ClockFrame& moving,
                                                          const ClockCamera& camera);

}  // namespace cvo_slam
