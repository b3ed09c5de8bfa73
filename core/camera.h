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

/// Applies Brown's lens distortion to the normalised coordinates (x, y) = (X/Z, Y/Z), in place:
/// D. C. Brown, "Decentering distortion of lenses", 1966, with the coefficients k1, k2, p1, p2, k3
/// in the order of OpenCV. Inline and for any scalar, so that loops over images vectorise.
template <typename Scalar>
inline void apply_brown_distortion(const std::array<Scalar, 5>& coefficients, Scalar& x,
                                   Scalar& y) {
  const auto& [k1, k2, p1, p2, k3] = coefficients;
  const Scalar r2 = x * x + y * y;
  const Scalar radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3));
  const Scalar twice_xy = 2 * x * y;
  const Scalar distorted_x = x * radial + p1 * twice_xy + p2 * (r2 + 2 * x * x);
  y = y * radial + p1 * (r2 + 2 * y * y) + p2 * twice_xy;
  x = distorted_x;
}

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

  /// Returns true if any distortion coefficient is not zero.
  [[nodiscard]] bool has_distortion() const;
  /// Returns the pixel of a point in the camera frame [m]; z must be positive.
  [[nodiscard]] Eigen::Vector2d project(const Vector3& point) const;
  /// Returns the point (x/z, y/z, 1) of a pixel; distortion is removed by fixed-point iteration.
  [[nodiscard]] Vector3 unproject(const Eigen::Vector2d& pixel) const;
  /// Returns true if the pixel lies on the image.
  [[nodiscard]] bool contains(const Eigen::Vector2d& pixel) const;

  /// Throws OptionError if a value is impossible: an image of more than 67 million pixels, a focal
  /// length that does not fit the image size, a principal point outside the image, distortion that
  /// no lens has.
  void check() const;
};

/// A separate depth camera, for sensors whose depth images are not registered to colour.
struct DepthCamera {
  PinholeCamera pinhole;  ///< its image is the depth image as the sensor gives it
  SE3 T_color_depth;      ///< pose of the depth camera in the frame of the colour camera [m]
};

/// The noise model of a sensor: the standard deviations of its measurements. The defaults are those
/// of the first Kinect.
struct SensorNoise {
  double depth_floor = 0.003;      ///< least standard deviation of a depth [m]
  double depth_quadratic = 0.003;  ///< standard deviation of a large depth z, divided by z^2 [1/m]
  double pixel = 1;                ///< of a feature's position in the colour image [px]

  /// Returns the standard deviation of a depth z [m].
  [[nodiscard]] double sigma_z(double z) const {
    return std::max(depth_floor, depth_quadratic * (z * z));
  }
};

/// An RGB-D camera. Frames handed to the tracker have depth registered to colour. If the sensor
/// does not do that, `depth` describes its depth camera and the reader of the data set registers
/// the images.
struct Camera {
  std::string name = "default";  ///< for messages and reports
  PinholeCamera color;           ///< the colour camera, to which depth is registered
  double depth_scale = 5000.0;   ///< units of the 16-bit depth image per metre
  /// Time that a rolling shutter takes from the first row to the last [s]; the stamp is the middle
  /// row's. 0 for a global shutter.
  double readout_time = 0;
  /// What is added to the stamps of depth images to get the time of the colour camera's clock [s],
  /// at most a million; -0.019 if they are 19 ms late. Empty = not known, taken as 0.
  std::optional<double> depth_offset;
  std::optional<DepthCamera> depth;  ///< empty = depth images are registered to colour
  SensorNoise noise;                 ///< how accurate depths and feature positions are

  /// Throws OptionError if a value is impossible: of one of its pinhole cameras, a depth scale that
  /// is not in [1, 1e6], or cameras that are more than 2 m apart.
  void check() const;
};

/// Returns true if two cameras make the same images of the same scene: whatever their names, depth
/// offsets and noise are.
[[nodiscard]] bool is_same_camera(const Camera& a, const Camera& b);

}  // namespace cvo_slam
