// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>

#include "cvo_slam/frontend/kernel_shape_internal.h"
#include "cvo_slam/frontend/neighbor_search_internal.h"
#include "cvo_slam/frontend/pair_table_internal.h"

namespace cvo_slam {
namespace {

constexpr std::size_t kChunk = 256;
/// A coordinate further away than any neighbour, whose square is still a float [m].
constexpr float kFarAway = 1e6F;

}  // namespace

void PairTable::build(const NeighborGrid& grid, const PointCloud& moving, std::size_t count,
                      const SE3& T_fixed_moving, const KernelOptions& kernel, double length_scale,
                      const Executor& executor) {
  lists_.resize(std::max(lists_.size(), Executor::chunk_count(count, kChunk)));
  executor.for_each_chunk(count, kChunk, [&](std::size_t k, std::size_t begin, std::size_t end) {
    find_neighbors(grid, moving, T_fixed_moving, kernel, length_scale, begin, end, lists_[k]);
  });
  group_by_count(count);
  T_fixed_moving_ = T_fixed_moving;
  fixed_count_ = grid.size();
  moving_count_ = count;
  radius_ = grid.radius();
  fill();
  set_points(moving, kernel, length_scale);
  skin_ = radius_ - support_radius(kernel, length_scale);
  built_ = true;
}

bool PairTable::reuse(const NeighborGrid& grid, const PointCloud& moving, std::size_t count,
                      const KernelOptions& kernel, double length_scale) {
  // A wider table has more pairs that do not count: half as many again cost less than a search.
  constexpr double kWidest = 1.25;
  const double support = support_radius(kernel, length_scale);
  const bool fits = built_ && fixed_count_ == grid.size() && moving_count_ == count &&
                    radius_ >= support && radius_ <= kWidest * grid.radius();
  if (!fits) return false;
  double farthest2 = 0;
  for (std::size_t j = 0; j < count; ++j) {
    farthest2 = std::max(farthest2, (moving.position(j) - positions_[j]).squaredNorm());
  }
  set_points(moving, kernel, length_scale);
  skin_ = radius_ - support - std::sqrt(farthest2);
  return true;
}

bool PairTable::covers(const SE3& T_fixed_moving) const {
  if (!built_) return false;
  const SE3 change = T_fixed_moving_.inverse() * T_fixed_moving;
  return change.translation().norm() + change.angle() * max_range_ <= skin_;
}

/// Sorts the points that have neighbours by how many, so that a group's rows are nearly full.
void PairTable::group_by_count(std::size_t count) {
  constexpr std::uint32_t kMost = 1023;  // points with more neighbours are left unsorted
  bucket_.assign(kMost + 2, 0);
  list_begin_.resize(count);
  const auto count_of = [&](std::size_t j) { return lists_[j / kChunk].count[j % kChunk]; };
  const auto bucket_of = [&](std::size_t j) { return kMost - std::min(count_of(j), kMost); };
  std::uint32_t begin = 0;
  for (std::size_t j = 0; j < count; ++j) {
    if (j % kChunk == 0) begin = 0;
    list_begin_[j] = begin;
    begin += count_of(j);
    ++bucket_[bucket_of(j) + 1];
  }
  for (std::size_t b = 1; b < bucket_.size(); ++b) bucket_[b] += bucket_[b - 1];
  const std::size_t with_neighbors = bucket_[kMost];
  order_.resize(count);
  for (std::size_t j = 0; j < count; ++j) {
    order_[bucket_[bucket_of(j)]++] = static_cast<std::uint32_t>(j);
  }
  order_.resize(with_neighbors);
}

/// Lays the pairs out.
void PairTable::fill() {
  groups_.resize(Executor::chunk_count(order_.size(), kLanes));
  std::size_t rows_used = 0;
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    Group& group = groups_[g];
    const std::size_t points = std::min(kLanes, order_.size() - g * kLanes);
    std::size_t most = 0;
    for (std::size_t lane = 0; lane < points; ++lane) {
      const std::size_t j = order_[g * kLanes + lane];
      most = std::max<std::size_t>(most, lists_[j / kChunk].count[j % kChunk]);
    }
    group.row_begin = rows_used;
    group.row_end = rows_used += most;
    if (rows_.size() < rows_used) rows_.resize(2 * rows_used);
    Row* const rows = rows_.data() + group.row_begin;
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      std::size_t n = 0;
      if (lane < points) {
        const std::size_t j = order_[g * kLanes + lane];
        const NeighborLists& lists = lists_[j / kChunk];
        const std::size_t begin = list_begin_[j];
        for (; n < lists.count[j % kChunk]; ++n) {
          rows[n].x[lane] = lists.x[begin + n];
          rows[n].y[lane] = lists.y[begin + n];
          rows[n].z[lane] = lists.z[begin + n];
          rows[n].c[lane] = lists.c[begin + n];
        }
      }
      for (; n < most; ++n) {
        rows[n].x[lane] = rows[n].y[lane] = rows[n].z[lane] = kFarAway;
        rows[n].c[lane] = 0;
      }
    }
  }
}

/// Sets the places of the moving points and the shapes of their kernels.
void PairTable::set_points(const PointCloud& moving, const KernelOptions& kernel,
                           double length_scale) {
  positions_.resize(moving_count_);
  double max_range2 = 0;
  for (std::size_t j = 0; j < moving_count_; ++j) {
    positions_[j] = moving.position(j);
    max_range2 = std::max(max_range2, positions_[j].squaredNorm());
  }
  max_range_ = std::sqrt(max_range2);

  has_shapes_ = is_shaped(moving, kernel);
  const Matrix3 rotation = T_fixed_moving_.rotation();
  for (std::size_t k = 0; k < groups_.size() * kLanes; ++k) {
    Group& group = groups_[k / kLanes];
    const std::size_t lane = k % kLanes;
    const bool is_point = k < order_.size();
    const Vector3 p = is_point ? positions_[order_[k]] : Vector3(Vector3::Zero());
    group.x[lane] = static_cast<float>(p.x());
    group.y[lane] = static_cast<float>(p.y());
    group.z[lane] = static_cast<float>(p.z());
    const Matrix3 P = is_point && has_shapes_
                          ? kernel_precision(moving, order_[k], rotation, kernel, length_scale)
                          : Matrix3(Matrix3::Identity());
    const std::array<double, 6> upper = {P(0, 0), P(0, 1), P(0, 2), P(1, 1), P(1, 2), P(2, 2)};
    for (std::size_t i = 0; i < group.P.size(); ++i) {
      group.P[i][lane] = static_cast<float>(upper[i]);
    }
  }
}

}  // namespace cvo_slam
