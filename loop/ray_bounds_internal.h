// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cvo_slam/core/camera.h"

namespace cvo_slam {

/// The rays (x, y, 1) that end in a camera's image, except at its rounded rims. Projecting a point
/// to a pixel instead would be wrong: Brown's polynomials map points far outside back into the
/// image.
class RayBounds {
 public:
  explicit RayBounds(const PinholeCamera& camera) {
    const double right = camera.width - 1;
    const double bottom = camera.height - 1;
    for (const double u : {0.0, right / 2, right}) {
      for (const double v : {0.0, bottom / 2, bottom}) {
        const Vector3 ray = camera.unproject({u, v});
        min_ = min_.cwiseMin(ray.head<2>());
        max_ = max_.cwiseMax(ray.head<2>());
      }
    }
  }

  /// Returns true if a ray ends in the image.
  [[nodiscard]] bool contains(const Eigen::Vector2d& ray) const {
    return (ray.array() >= min_.array()).all() && (ray.array() <= max_.array()).all();
  }

  /// Returns the position of a ray between the rims, in [0, 1) for each coordinate.
  [[nodiscard]] Eigen::Vector2d share(const Eigen::Vector2d& ray) const {
    constexpr double kBelowOne = 1 - 1e-9;
    const Eigen::Vector2d share = (ray - min_).cwiseQuotient(max_ - min_);
    return share.cwiseMax(0).cwiseMin(kBelowOne);
  }

 private:
  Eigen::Vector2d min_ = Eigen::Vector2d::Constant(1e9);
  Eigen::Vector2d max_ = Eigen::Vector2d::Constant(-1e9);
};

}  // namespace cvo_slam
