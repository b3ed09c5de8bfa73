// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "cvo_slam/core/map.h"

namespace cvo_slam {

/// Weighted means of coloured points, one per voxel of the world.
class VoxelGrid {
 public:
  explicit VoxelGrid(double voxel_size);

  /// Adds a point; points farther than a million voxels from the origin are ignored.
  void add(const Vector3& position, const Eigen::Vector3f& normal,
           const std::array<std::uint8_t, 3>& color, float weight);

  /// Returns one point for each voxel with at least `min_count` points, in the order in which the
  /// voxels were met.
  [[nodiscard]] std::vector<MapPoint> points(int min_count) const;

 private:
  struct Sum {
    std::uint64_t key = 0;  // identifies the voxel
    Eigen::Vector3f
        position;  // relative to the voxel's corner, which keeps digits far from the origin
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
  std::size_t last_ = 0;  // index in sums_ of the last voxel used
  // Maps a key to its index in sums_: a hash table with open addressing, at most half full. A
  // std::unordered_map would take three quarters of the time of a whole fusion.
  std::vector<std::uint32_t> slots_;
};

}  // namespace cvo_slam
