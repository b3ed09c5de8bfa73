// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/loop/descriptor.h"
#include "cvo_slam/loop/orb_features.h"

namespace cvo_slam {

/// The features of a keyframe in 40 bytes each in place of 60: what a map keeps in memory and in
/// its files. They are rounded to
///
///   u, v     1/16 px, 1/8 px in images above 4096 px
///   depth    0.1 % (Eigen::half)
///   angle    1.4 degrees
///
/// which is below what corners are accurate to.
class CompactFeatures {
 public:
  CompactFeatures() = default;
  /// Keeps the descriptors of `features`, and rounds the rest.
  explicit CompactFeatures(const OrbFeatures& features);

  [[nodiscard]] const std::vector<Descriptor>& descriptors() const { return descriptors_; }
  /// The features, with the rays that the camera has for their pixels.
  [[nodiscard]] OrbFeatures features(const PinholeCamera& camera) const;
  /// Memory [bytes].
  [[nodiscard]] std::size_t bytes() const;

  /// Returns the bytes that from_bytes() takes. Integers and floats are little-endian.
  [[nodiscard]] std::string to_bytes() const;
  /// Throws DataError if the bytes are not those of features.
  [[nodiscard]] static CompactFeatures from_bytes(std::string_view bytes);

 private:
  struct Point {
    std::uint16_t u = 0, v = 0;  // [1/pixel_steps_ px]
    std::uint16_t depth = 0;     // bits of an Eigen::half [m]; 0 = unknown
    std::uint8_t angle = 0;      // [1/256 turn]
    std::uint8_t size = 0;       // index in sizes_
  };

  float pixel_steps_ = 16;
  std::vector<float> sizes_;  // of the levels of the pyramid [px], as far as they have features
  std::vector<Point> points_;
  std::vector<Descriptor> descriptors_;
};

}  // namespace cvo_slam
