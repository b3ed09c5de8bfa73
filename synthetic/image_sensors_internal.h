// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the chips of a depth camera and of a colour camera make of ideal images.
#pragma once

#include <cstdint>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/synthetic/rendering_internal.h"
#include "cvo_slam/synthetic/sensor_options.h"

namespace cvo_slam::synthetic {

/// Return the standard deviations of a Kinect's depth along the ray [m] and across it [px], at
/// depth `z` [m] on a surface whose normal is at `angle` [rad] to the ray: C. V. Nguyen, S. Izadi,
/// D. Lovell, "Modeling Kinect Sensor Noise for Improved 3D Reconstruction and Tracking", 3DIMPVT
/// 2012. The formulas grow without bound near 90 deg, so angles beyond 85 deg count as 85 deg.
[[nodiscard]] double kinect_axial_noise(double z, double angle);
[[nodiscard]] double kinect_lateral_noise(double angle);

/// Returns the difference between depths near `z` [m] whose disparities differ by `step` [px], for
/// the focal length and baseline of the Kinect [m].
[[nodiscard]] double kinect_depth_step(double z, double step);

/// Returns for each pixel of a row of depths [m] whether it is hidden from a projector that is
/// `baseline` [m] to the right of the camera. `fx` is the focal length of the camera [px].
[[nodiscard]] std::vector<bool> hidden_from_projector(const double* depths, int width, double fx,
                                                      double baseline);

/// Turns ideal images into the depth image that a structured-light camera measures.
class DepthSensor {
 public:
  DepthSensor(const Camera& camera, const DepthNoiseOptions& options)
      : camera_(camera), options_(options) {}

  /// Returns the images that measure() needs.
  [[nodiscard]] Channels channels() const;
  /// Returns the depth image: CV_16UC1 in depth units of the camera, 0 = no depth. `seed` is the
  /// seed of the frame.
  [[nodiscard]] cv::Mat measure(const IdealImages& ideal, std::uint32_t seed) const;

 private:
  struct NoiseFields {
    cv::Mat along, right, down;
  };

  [[nodiscard]] NoiseFields noise_fields(std::uint32_t seed) const;
  [[nodiscard]] cv::Mat gaps(std::uint32_t seed) const;
  [[nodiscard]] cv::Mat labels(const IdealImages& ideal) const;
  [[nodiscard]] cv::Point displaced(const IdealImages& ideal, const cv::Mat& labels,
                                    const NoiseFields& noise, const cv::Point& at) const;
  [[nodiscard]] bool returns_light(const IdealImages& ideal, const cv::Point& at) const;
  [[nodiscard]] double disturbed(double depth, double angle, double noise) const;
  [[nodiscard]] std::uint16_t to_units(double depth) const;

  const Camera& camera_;
  const DepthNoiseOptions& options_;
};

/// Returns the brightness of an image taken at `seconds` relative to the default exposure: slow
/// drift and jumps of an automatic exposure. 1 if both are off.
[[nodiscard]] double exposure_gain(const ExposureOptions& options, std::uint32_t seed,
                                   double seconds);

/// Returns the colour image (CV_8UC3) that the chip makes of light (CV_32FC3, grey levels), with
/// read noise and shot noise; light that is too bright becomes white. `seed` is the seed of the
/// frame.
[[nodiscard]] cv::Mat expose(const cv::Mat& light, double gain, const ImageNoiseOptions& options,
                             std::uint32_t seed);

}  // namespace cvo_slam::synthetic
