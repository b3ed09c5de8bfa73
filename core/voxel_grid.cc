// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "cvo_slam/core/voxel_grid_internal.h"

namespace cvo_slam {
namespace {

/// 21 bits a coordinate make a key of 63.
constexpr double kMostCells = 1 << 20;

std::uint64_t key_of(const Vector3& cell) {
  std::uint64_t key = 0;
  for (const double coordinate : cell) {
    key = (key << 21U) | static_cast<std::uint64_t>(coordinate + kMostCells);
  }
  return key;
}

std::uint8_t to_byte(float level) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(level, 0.0F, 255.0F)));
}

}  // namespace

VoxelGrid::Sum& VoxelGrid::sum_at(const Vector3& cell) {
  const auto [entry, is_new] =
      index_.try_emplace(key_of(cell), static_cast<std::uint32_t>(sums_.size()));
  if (is_new) {
    const Eigen::Vector3f zero = Eigen::Vector3f::Zero();
    sums_.push_back({cell * size_, zero, zero, zero});
  }
  return sums_[entry->second];
}

void VoxelGrid::add(const Vector3& position, const Eigen::Vector3f& normal,
                    const std::array<std::uint8_t, 3>& color, float weight) {
  const Vector3 cell = (position / size_).array().floor();
  if (!(cell.cwiseAbs().maxCoeff() < kMostCells)) return;
  Sum& sum = sum_at(cell);
  sum.position += weight * (position - sum.corner).cast<float>();
  sum.normal += weight * normal;
  sum.color += weight * Eigen::Vector3f(color[0], color[1], color[2]);
  sum.weight += weight;
}

std::vector<MapPoint> VoxelGrid::points() const {
  std::vector<MapPoint> points;
  points.reserve(sums_.size());
  for (const Sum& sum : sums_) {
    const Eigen::Vector3f color = sum.color / sum.weight;
    MapPoint point;
    point.position = (sum.corner + (sum.position / sum.weight).cast<double>()).cast<float>();
    // Both sides of a thin board cancel; then no side is to be preferred.
    constexpr float kLeastAgreement = 0.2F;
    const float agreement = sum.normal.norm() / sum.weight;
    if (agreement > kLeastAgreement) point.normal = sum.normal.normalized();
    point.color = {to_byte(color[0]), to_byte(color[1]), to_byte(color[2])};
    points.push_back(point);
  }
  return points;
}

}  // namespace cvo_slam
