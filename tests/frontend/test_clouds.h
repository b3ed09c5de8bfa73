// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>

#include "cvo_slam/core/point_cloud.h"

namespace cvo_slam {

/// Returns `n` seeded points, uniform in a 1 m cube that begins 1 m in front of the camera, with
/// uniform features.
inline PointCloud random_cloud(std::size_t n, unsigned seed) {
  std::mt19937 rng(seed);
  std::uniform_real_distribution<float> unit(0.0F, 1.0F);
  PointCloud cloud;
  cloud.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    cloud.x[i] = unit(rng) - 0.5F;
    cloud.y[i] = unit(rng) - 0.5F;
    cloud.z[i] = unit(rng) + 1.0F;
    for (std::size_t f = 0; f < PointCloud::kFeatures; ++f) {
      cloud.features[f][i] = f < 3 ? 255 * unit(rng) : 100 * (unit(rng) - 0.5F);
    }
  }
  return cloud;
}

/// Returns the cloud with every point p moved to T p; features stay.
inline PointCloud transformed(const PointCloud& cloud, const SE3& T) {
  PointCloud moved = cloud;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Vector3 p = T * cloud.position(i);
    moved.x[i] = static_cast<float>(p.x());
    moved.y[i] = static_cast<float>(p.y());
    moved.z[i] = static_cast<float>(p.z());
  }
  return moved;
}

/// Returns the points in the order of `order`, which may leave some out.
inline PointCloud subset(const PointCloud& cloud, const std::vector<std::size_t>& order) {
  PointCloud result;
  result.resize(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    const std::size_t i = order[k];
    result.x[k] = cloud.x[i];
    result.y[k] = cloud.y[i];
    result.z[k] = cloud.z[i];
    for (std::size_t f = 0; f < PointCloud::kFeatures; ++f) {
      result.features[f][k] = cloud.features[f][i];
    }
  }
  return result;
}

inline SE3 motion(double tx, double ty, double tz, double rx, double ry, double rz) {
  return SE3::exp((Vector6() << tx, ty, tz, rx, ry, rz).finished());
}

}  // namespace cvo_slam
