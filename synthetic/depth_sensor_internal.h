// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include <opencv2/core/mat.hpp>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/synthetic/picture_internal.h"
#include "cvo_slam/synthetic/sensor_options.h"

namespace cvo_slam::synthetic {

/// Standard deviations of a Kinect's depth at depth `z` [m] of a surface whose normal is at `angle`
/// [rad] to the ray, along the ray [m] and across it [px]: C. V. Nguyen, S. Izadi, D. Lovell,
/// "Modeling Kinect Sensor Noise for Improved 3D Reconstruction and Tracking", 3DIMPVT 2012. Angles
/// beyond 85 deg, where the formulas grow without bound, count as 85 deg.
[[nodiscard]] double kinect_axial_noise(double z, double angle);
[[nodiscard]] double kinect_lateral_noise(double angle);

/// The difference of the depths about `z` that belong to disparities `step` [px] apart [m], for the
/// Kinect's focal length and baseline.
[[nodiscard]] double kinect_depth_step(double z, double step);

/// Which of the pixels of a row of depths [m] are hidden from a projector that stands `baseline`
/// [m] to the camera's right; `fx` is the camera's focal length [px].
[[nodiscard]] std::vector<bool> hidden_from_projector(const double* depths, int width, double fx,
                                                      double baseline);

/// Makes of what there is what a depth camera measures.
class DepthSensor {
 public:
  DepthSensor(const Camera& camera, const DepthNoiseOptions& options)
      : camera_(camera), options_(options) {}

  /// What measure() needs of a picture.
  [[nodiscard]] Channels channels() const;
  /// CV_16UC1 in the camera's depth units, 0 = no depth. `seed` is that of the frame.
  [[nodiscard]] cv::Mat measure(const Picture& picture, std::uint32_t seed) const;

 private:
  struct NoiseFields {
    cv::Mat along, right, down;
  };

  [[nodiscard]] NoiseFields noise_fields(std::uint32_t seed) const;
  [[nodiscard]] cv::Mat gaps(std::uint32_t seed) const;
  [[nodiscard]] cv::Mat labels(const Picture& picture) const;
  [[nodiscard]] cv::Point displaced(const Picture& picture, const cv::Mat& labels,
                                    const NoiseFields& noise, const cv::Point& at) const;
  [[nodiscard]] bool returns_light(const Picture& picture, const cv::Point& at) const;
  [[nodiscard]] double disturbed(double depth, double angle, double noise) const;
  [[nodiscard]] std::uint16_t to_units(double depth) const;

  const Camera& camera_;
  const DepthNoiseOptions& options_;
};

}  // namespace cvo_slam::synthetic
