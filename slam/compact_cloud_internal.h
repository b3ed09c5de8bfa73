// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cvo_slam/core/point_cloud.h"

namespace cvo_slam {

/// A keyframe's points in 11 bytes each, or 14 with surfaces, in place of 40 and more: what the map
/// keeps in memory and in its files. Points are rounded to
///
///   x/z, y/z   1/8192, at most 4: a sixteenth of a pixel of a Kinect
///   z          0.014 %, 2 cm to 190 m: a quarter of a millimetre at 2 m
///   colours    1 of 255; gradients 1 of 127, of the largest of the cloud if that is above
///   surfaces   normals half a degree, roughness 5 %
///
/// which is below the noise of every depth camera. Their ray noise is kept as the two numbers of
/// SensorNoise::sigma_z() that it comes from. Pixels (PointCloud::u, v) are not kept: they
/// serve a cloud only until its keyframe is final.
class CompactCloud {
 public:
  CompactCloud() = default;
  explicit CompactCloud(const PointCloud& cloud);

  [[nodiscard]] std::size_t size() const { return points_.size(); }
  [[nodiscard]] Vector3 position(std::size_t i) const;
  /// The points; PointCloud::u and v are 0.
  [[nodiscard]] PointCloud points() const;
  /// Memory [bytes].
  [[nodiscard]] std::size_t bytes() const;

  /// Returns the bytes that from_bytes() takes. Integers and floats are little-endian.
  [[nodiscard]] std::string to_bytes() const;
  /// Throws DataError if the bytes are not those of a cloud.
  [[nodiscard]] static CompactCloud from_bytes(std::string_view bytes);

 private:
  /// An integer of 16 bits without the padding that it would bring.
  using TwoBytes = std::array<std::uint8_t, 2>;
  struct Point {
    TwoBytes x = {}, y = {};  // x/z, y/z (int16)
    TwoBytes log_z = {};      // uint16
    std::uint8_t blue = 0, green = 0, red = 0;
    std::int8_t dx = 0, dy = 0;
  };
  struct Surface {
    std::int8_t a = 0, b = 0;        // of the normal, as a point of an octahedron
    std::uint8_t log_roughness = 0;  // 0 = no surface
  };

  /// Standard deviation along the ray of a point at depth z: max(floor, quadratic z^2) |p| / z [m].
  struct RayNoise {
    float floor = 0;  // 0 = not known
    float quadratic = 0;

    [[nodiscard]] static RayNoise of(const PointCloud& cloud);
    [[nodiscard]] float at(const Vector3& point) const;
  };

  float color_step_ = 1;
  float gradient_step_ = 1;
  float surface_noise_ = 0;
  RayNoise ray_noise_;
  std::vector<Point> points_;
  std::vector<Surface> surfaces_;  // as many as points, or none
};

}  // namespace cvo_slam
