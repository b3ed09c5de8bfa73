// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "cvo_slam/core/voxel_grid_internal.h"

namespace cvo_slam {
namespace {

/// A key has 21 bits per coordinate, 63 in all.
constexpr double kMostCells = 1 << 20;

std::uint64_t key_of(const Vector3& cell) {
  std::uint64_t key = 0;
  for (const double coordinate : cell) {
    key = (key << 21U) | static_cast<std::uint64_t>(coordinate + kMostCells);
  }
  return key;
}

Vector3 cell_of(std::uint64_t key) {
  constexpr std::uint64_t kMask = (1U << 21U) - 1;
  return Vector3(static_cast<double>(key >> 42U), static_cast<double>((key >> 21U) & kMask),
                 static_cast<double>(key & kMask)) -
         Vector3::Constant(kMostCells);
}

constexpr std::uint32_t kFree = std::numeric_limits<std::uint32_t>::max();

std::uint8_t to_byte(float level) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(level, 0.0F, 255.0F)));
}

}  // namespace

VoxelGrid::VoxelGrid(double voxel_size) : size_(voxel_size), slots_(1U << 16U, kFree) {}

std::size_t VoxelGrid::slot_of(std::uint64_t key) const {
  // 2^64 / golden ratio: the upper bits of the product depend on all of the key.
  const std::uint64_t hash = key * 0x9e3779b97f4a7c15ULL;
  const std::size_t mask = slots_.size() - 1;
  auto slot = static_cast<std::size_t>(hash >> 32U) & mask;
  while (slots_[slot] != kFree && sums_[slots_[slot]].key != key) slot = (slot + 1) & mask;
  return slot;
}

void VoxelGrid::grow() {
  slots_.assign(2 * slots_.size(), kFree);
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    slots_[slot_of(sums_[i].key)] = static_cast<std::uint32_t>(i);
  }
}

VoxelGrid::Sum& VoxelGrid::sum_at(std::uint64_t key) {
  // Consecutive pixels often fall into the same voxel.
  if (!sums_.empty() && sums_[last_].key == key) return sums_[last_];
  std::size_t slot = slot_of(key);
  if (slots_[slot] == kFree) {
    if (2 * sums_.size() >= slots_.size()) {
      grow();
      slot = slot_of(key);
    }
    slots_[slot] = static_cast<std::uint32_t>(sums_.size());
    const Eigen::Vector3f zero = Eigen::Vector3f::Zero();
    sums_.push_back({key, zero, zero, zero});
  }
  last_ = slots_[slot];
  return sums_[last_];
}

void VoxelGrid::add(const Vector3& position, const Eigen::Vector3f& normal,
                    const std::array<std::uint8_t, 3>& color, float weight) {
  const Vector3 cell = (position / size_).array().floor();
  if (!(cell.cwiseAbs().maxCoeff() < kMostCells)) return;
  Sum& sum = sum_at(key_of(cell));
  sum.position += weight * (position - size_ * cell).cast<float>();
  sum.normal += weight * normal;
  sum.color += weight * Eigen::Vector3f(color[0], color[1], color[2]);
  sum.weight += weight;
  ++sum.count;
}

std::vector<MapPoint> VoxelGrid::points(int min_count) const {
  std::vector<MapPoint> points;
  points.reserve(sums_.size());
  for (const Sum& sum : sums_) {
    if (sum.count < min_count) continue;
    const Eigen::Vector3f color = sum.color / sum.weight;
    MapPoint point;
    point.position =
        (size_ * cell_of(sum.key) + (sum.position / sum.weight).cast<double>()).cast<float>();
    // The normals of the two sides of a thin board cancel; the point then has no normal.
    constexpr float kLeastAgreement = 0.2F;
    const float agreement = sum.normal.norm() / sum.weight;
    if (agreement > kLeastAgreement) point.normal = sum.normal.normalized();
    point.color = {to_byte(color[0]), to_byte(color[1]), to_byte(color[2])};
    points.push_back(point);
  }
  return points;
}

}  // namespace cvo_slam
