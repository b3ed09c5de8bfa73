// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/rgbd_frame.h"
#include "cvo_slam/core/se3.h"

namespace cvo_slam {

/// Returns the share of the surface in b's depth image that a sees as well, in [0, 1].
inline double visible_overlap(const RgbdFrame& a, const RgbdFrame& b, const SE3& T_a_b,
                              const Camera& camera) {
  constexpr int kGrid = 16;  // [px]
  int total = 0;
  int seen = 0;
  for (int v = kGrid / 2; v < b.depth.rows; v += kGrid) {
    for (int u = kGrid / 2; u < b.depth.cols; u += kGrid) {
      const double z = b.depth.at<std::uint16_t>(v, u) / camera.depth_scale;
      if (z <= 0) continue;
      ++total;
      const Vector3 p = T_a_b * (z * camera.color.unproject({u, v}));
      if (p.z() <= 0.1) continue;
      const Eigen::Vector2d pixel = camera.color.project(p);
      if (!camera.color.contains(pixel)) continue;
      const double there =
          a.depth.at<std::uint16_t>(static_cast<int>(pixel.y()), static_cast<int>(pixel.x())) /
          camera.depth_scale;
      // A pixel of a without a depth counts as seen: nothing shows that the point is hidden.
      if (there <= 0 || std::abs(there - p.z()) < 0.05 + 0.05 * p.z()) ++seen;
    }
  }
  return total > 0 ? static_cast<double>(seen) / total : 0;
}

/// Returns visible_overlap() of a and b or of b and a, the smaller one.
inline double mutual_overlap(const RgbdFrame& a, const RgbdFrame& b, const SE3& T_a_b,
                             const Camera& camera) {
  return std::min(visible_overlap(a, b, T_a_b, camera),
                  visible_overlap(b, a, T_a_b.inverse(), camera));
}

}  // namespace cvo_slam
