// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "cvo_slam/core/point_cloud.h"
#include "cvo_slam/frontend/kernel.h"

namespace cvo_slam {

/// A run of consecutive entries of a NeighborGrid.
struct GridRun {
  std::uint32_t begin;
  std::uint32_t end;
};

/// The points of a cloud sorted so that all within the kernel's support of a place are a few
/// contiguous runs. Points are binned in (y, z) into square columns as wide as the support radius,
/// and sorted by x within each column: a query looks at 3x3 columns and, by bisection, at the part
/// of each within the radius in x.
class NeighborGrid {
 public:
  static constexpr std::size_t kMaxRuns = 9;
  static constexpr std::size_t kPadding = 16;  ///< floats in the widest vector

  /// Sorts a copy of `cloud`. Points without finite coordinates are left out.
  void build(const PointCloud& cloud, double radius);

  [[nodiscard]] std::size_t size() const { return order_.size(); }
  [[nodiscard]] double radius() const { return radius_; }
  /// The sorted points, size() of them and kPadding unused entries, so that vector loads may read
  /// past the end. Entry k is point order()[k] of the cloud that was given to build(). Pixels are
  /// not kept.
  [[nodiscard]] const PointCloud& points() const { return points_; }
  [[nodiscard]] const std::vector<std::uint32_t>& order() const { return order_; }

  /// Writes the non-empty runs that hold every point within radius() of (x, y, z), and others;
  /// returns how many runs there are.
  std::size_t query(float x, float y, float z, std::array<GridRun, kMaxRuns>& runs) const;

 private:
  [[nodiscard]] std::int64_t column_of(float y, float z) const;

  PointCloud points_;
  std::vector<std::uint32_t> order_;
  std::vector<std::uint32_t> column_begin_;  // columns_y_ * columns_z_ + 1 entries
  double radius_ = 0;
  float inverse_width_ = 0;
  float min_y_ = 0;
  float min_z_ = 0;
  std::int64_t columns_y_ = 0;
  std::int64_t columns_z_ = 0;
};

}  // namespace cvo_slam
