// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "cvo_slam/core/map.h"

namespace cvo_slam {

/// Weighted means of coloured points, one a voxel of the world.
class VoxelGrid {
 public:
  explicit VoxelGrid(double voxel_size) : size_(voxel_size) {}

  /// Points further than a million voxels from the origin are left out.
  void add(const Vector3& position, const Eigen::Vector3f& normal,
           const std::array<std::uint8_t, 3>& color, float weight);

  /// One point a voxel, in the order in which the voxels were met.
  [[nodiscard]] std::vector<MapPoint> points() const;

 private:
  struct Sum {
    Vector3 corner;            // of the voxel: the sums below keep their digits far from the origin
    Eigen::Vector3f position;  // from the corner
    Eigen::Vector3f normal;
    Eigen::Vector3f color;
    float weight = 0;
  };
  struct Hash {
    std::size_t operator()(std::uint64_t key) const {
      key *= 0x9e3779b97f4a7c15ULL;  // 2^64 / golden ratio: neighbours go far apart
      return static_cast<std::size_t>(key ^ (key >> 32U));
    }
  };

  Sum& sum_at(const Vector3& cell);

  double size_;
  std::unordered_map<std::uint64_t, std::uint32_t, Hash> index_;  // in sums_
  std::vector<Sum> sums_;
};

}  // namespace cvo_slam
