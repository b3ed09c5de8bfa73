// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "cvo_slam/core/map.h"

namespace cvo_slam {

/// Weighted means of coloured points, one a voxel of the world.
class VoxelGrid {
 public:
  explicit VoxelGrid(double voxel_size);

  /// Points further than a million voxels from the origin are left out.
  void add(const Vector3& position, const Eigen::Vector3f& normal,
           const std::array<std::uint8_t, 3>& color, float weight);

  /// One point a voxel with at least so many, in the order in which the voxels were met.
  [[nodiscard]] std::vector<MapPoint> points(int min_count) const;

 private:
  struct Sum {
    std::uint64_t key = 0;     // of the voxel
    Eigen::Vector3f position;  // from the voxel's corner: keeps its digits far from the origin
    Eigen::Vector3f normal;
    Eigen::Vector3f color;
    float weight = 0;
    int count = 0;
  };

  Sum& sum_at(std::uint64_t key);
  [[nodiscard]] std::size_t slot_of(std::uint64_t key) const;
  void grow();

  double size_;
  std::vector<Sum> sums_;
  std::size_t last_ = 0;  // that was asked for
  // Where in sums_ a key is: a hash table with open addressing, at most half full, because a
  // std::unordered_map takes three quarters of the time of a whole fusion.
  std::vector<std::uint32_t> slots_;
};

}  // namespace cvo_slam
