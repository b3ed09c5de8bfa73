// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>
#include <vector>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/loop/pose_search_internal.h"

namespace cvo_slam {

/// Points that two cameras see, with noise, from seeded random numbers.
class PairSource {
 public:
  PairSource(const Camera& camera, const SE3& T_a_b, unsigned seed)
      : camera_(camera.color), T_a_b_(T_a_b), engine_(seed) {}

  double uniform(double min, double max) {
    return min + (max - min) * static_cast<double>(engine_()) / 4294967296.0;
  }
  /// Returns a normally distributed number (Box and Muller).
  double normal() {
    return std::sqrt(-2 * std::log(uniform(1e-9, 1))) * std::cos(uniform(0, 2 * std::numbers::pi));
  }

  /// Returns a point seen by both cameras. `pixels` and `depth` (at up to a metre; it grows with
  /// the square of the depth) are the standard deviations.
  PointPair inlier(double pixels, double depth) {
    constexpr int kMostTries = 10000;  // most points are seen by both
    for (int i = 0; i < kMostTries; ++i) {
      const double z = uniform(0.8, 3);
      const Vector3 in_a = z * camera_.unproject({uniform(10, camera_.width - 10),
                                                  uniform(10, camera_.height - 10)});
      const Vector3 in_b = T_a_b_.inverse() * in_a;
      if (in_b.z() < 0.3 || !camera_.contains(camera_.project(in_b))) continue;
      return {feature(in_a, pixels, depth), feature(in_b, pixels, depth)};
    }
    throw std::logic_error("the two cameras see nothing of the same");
  }

  PointPair outlier() { return {inlier(0, 0).a, inlier(0, 0).b}; }

 private:
  OrbFeature feature(const Vector3& position, double pixels, double depth) {
    OrbFeature feature;
    const Eigen::Vector2d pixel =
        camera_.project(position) + pixels * Eigen::Vector2d(normal(), normal());
    const Vector3 ray = camera_.unproject(pixel);
    feature.u = static_cast<float>(pixel.x());
    feature.v = static_cast<float>(pixel.y());
    feature.x = static_cast<float>(ray.x());
    feature.y = static_cast<float>(ray.y());
    const double z = position.z();
    feature.depth = static_cast<float>(z + depth * std::max(1.0, z * z) * normal());
    return feature;
  }

  PinholeCamera camera_;
  SE3 T_a_b_;
  std::mt19937 engine_;
};

}  // namespace cvo_slam
