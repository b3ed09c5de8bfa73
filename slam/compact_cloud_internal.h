// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cvo_slam/core/point_cloud.h"

namespace cvo_slam {

/// A keyframe's points in 12 bytes each, or 15 with surfaces, in place of 40 and more: what the map
/// keeps in memory and in its files. Points are rounded to
///
///   x/z, y/z   1/8192, at most 4: a sixteenth of a pixel of a Kinect
///   z          0.014 %, 2 cm to 190 m: a quarter of a millimetre at 2 m
///   colours    1 of 255; gradients 1 of 127, of the largest of the cloud if that is above
///   ray noise  5 %; roughness of a surface 5 %, its normal half a degree
///
/// which is below the noise of every depth camera. Pixels (PointCloud::u, v) are not kept: they
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

  /// Returns the bytes that from_bytes() takes, alike values beside each other so that they
  /// compress well.
  [[nodiscard]] std::string to_bytes() const;
  /// Throws DataError if the bytes are not those of a cloud.
  [[nodiscard]] static CompactCloud from_bytes(std::string_view bytes);

 private:
  struct Point {
    std::int16_t x = 0, y = 0;  // x/z, y/z
    std::uint16_t log_z = 0;
    std::uint8_t blue = 0, green = 0, red = 0;
    std::int8_t dx = 0, dy = 0;
    std::uint8_t log_ray_noise = 0;
  };
  struct Surface {
    std::int8_t a = 0, b = 0;        // of the normal, as a point of an octahedron
    std::uint8_t log_roughness = 0;  // 0 = no surface
  };

  float color_step_ = 1;
  float gradient_step_ = 1;
  float surface_noise_ = 0;
  bool has_ray_noise_ = false;
  std::vector<Point> points_;
  std::vector<Surface> surfaces_;  // as many as points, or none
};

}  // namespace cvo_slam
