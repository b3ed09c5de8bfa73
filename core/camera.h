// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include <Eigen/Core>

#include "cvo_slam/core/se3.h"

namespace cvo_slam {

/// A pinhole camera with Brown's distortion. Pixel (0, 0) is the centre of the upper left pixel;
/// the camera looks along +z with x to the right and y down (fy < 0 flips y, as in ICL-NUIM).
struct PinholeCamera {
  int width = 640;    ///< [px]
  int height = 480;   ///< [px]
  double fx = 525.0;  ///< [px]
  double fy = 525.0;  ///< [px]
  double cx = 319.5;  ///< [px]
  double cy = 239.5;  ///< [px]
  /// k1, k2, p1, p2, k3 as in OpenCV; all zero = no distortion.
  std::array<double, 5> distortion = {0, 0, 0, 0, 0};

  [[nodiscard]] bool has_distortion() const;
  /// The pixel of a point in the camera frame [m]; z must be positive.
  [[nodiscard]] Eigen::Vector2d project(const Vector3& point) const;
  /// The point (x/z, y/z, 1) of a pixel, distortion removed by fixed-point iteration.
  [[nodiscard]] Vector3 unproject(const Eigen::Vector2d& pixel) const;
  /// True where the pixel lies on the image.
  [[nodiscard]] bool contains(const Eigen::Vector2d& pixel) const;

  /// Throws OptionError where a size or focal length is impossible.
  void check() const;
};

/// A depth camera of its own, for sensors whose depth images are not registered to colour.
struct DepthCamera {
  PinholeCamera pinhole;
  SE3 T_color_depth;
};

/// The noise model of a sensor: how far its measurements scatter, as standard deviations.
struct SensorNoise {
  double depth_floor = 0.003;      ///< of a depth of up to about a metre [m]
  double depth_quadratic = 0.003;  ///< of a depth z beyond, over z^2 [1/m]
  double pixel = 1;                ///< of where a feature is found in the colour image [px]

  /// Standard deviation of a depth z [m].
  [[nodiscard]] double sigma_z(double z) const {
    return std::max(depth_floor, depth_quadratic * z * z);
  }
};

/// An RGB-D camera. Frames handed to the tracker have depth registered to colour; where the sensor
/// does not do that, `depth` says how and the dataset reader does it.
struct Camera {
  std::string name = "default";  ///< for messages and reports
  PinholeCamera color;
  double depth_scale = 5000.0;  ///< units of the 16-bit depth image a metre
  /// Of a rolling shutter: from the first row to the last [s]; the stamp is the middle row's. 0 for
  /// a global shutter.
  double readout_time = 0;
  std::optional<DepthCamera> depth;
  SensorNoise noise;

  /// Throws OptionError where a value is impossible.
  void check() const;
};

}  // namespace cvo_slam
