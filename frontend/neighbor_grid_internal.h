// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "cvo_slam/core/point_cloud.h"
#include "cvo_slam/frontend/registration.h"

namespace cvo_slam {

/// A run of consecutive entries of a NeighborGrid.
struct GridRun {
  std::uint32_t begin;
  std::uint32_t end;
};

/// The finite points of a cloud by ascending z; keeps its memory.
class PointsByDepth {
 public:
  void sort(const PointCloud& cloud);
  [[nodiscard]] const std::vector<std::uint32_t>& indices() const { return indices_; }

 private:
  std::vector<std::pair<float, std::uint32_t>> keys_;
  std::vector<std::uint32_t> indices_;
};

/// The points of a cloud, sorted so that all within the kernel's support of a position are a few
/// contiguous runs. Points are binned in (x, y) into square columns as wide as the support radius,
/// and sorted by z within each column, with a table of the first point of each half radius in z: a
/// query looks at 3x3 columns and at the part of each that the radius reaches. Kernels are longest
/// along the viewing rays, most of which go along z.
class NeighborGrid {
 public:
  static constexpr std::int64_t kMaxSide = 9;  ///< columns across that a query looks at
  static constexpr std::size_t kMaxRuns = kMaxSide * kMaxSide;
  static constexpr std::size_t kPadding = 16;  ///< floats in the widest vector

  /// Sorts a copy of the first `count` points. The grids of several radii share `by_depth`.
  void build(const PointCloud& cloud, const PointsByDepth& by_depth, std::size_t count,
             double radius);
  void build(const PointCloud& cloud, double radius);

  [[nodiscard]] std::size_t size() const { return order_.size(); }
  [[nodiscard]] double radius() const { return radius_; }
  /// Returns the sorted points: size() of them and kPadding unused entries, so that vector loads
  /// may read past the end. Entry k is point order()[k] of the cloud that was given to build().
  /// Pixels are not kept.
  [[nodiscard]] const PointCloud& points() const { return points_; }
  [[nodiscard]] const std::vector<std::uint32_t>& order() const { return order_; }

  /// Writes the non-empty runs that hold every point within radius() of (x, y, z), and others;
  /// returns how many runs there are.
  std::size_t query(float x, float y, float z, std::array<GridRun, kMaxRuns>& runs) const;

  /// The same for an ellipsoid about (x, y, z): a ball of radius() that is `stretch` >= 1 times as
  /// long along the unit vector `along`.
  std::size_t query(const Eigen::Array3f& center, const Eigen::Array3f& along, float stretch,
                    std::array<GridRun, kMaxRuns>& runs) const;

 private:
  /// A column's points begin at points_begin. The points of its bins of half a radius in z, from
  /// bin number first_bin on, begin at bins_[bins_begin], ...; there is one more entry than bins.
  struct Column {
    std::uint32_t points_begin = 0;
    std::uint32_t bins_begin = 0;
    std::int32_t first_bin = 0;
    std::int32_t bins = 0;
  };

  void set_extent(const Eigen::Array3f& low, const Eigen::Array3f& high);
  [[nodiscard]] std::int64_t column_of(float x, float y) const;
  [[nodiscard]] std::int32_t bin_of(float z) const;
  [[nodiscard]] bool is_near(const Eigen::Array3f& center) const;
  void add_run(const Column& column, float low, float high, std::array<GridRun, kMaxRuns>& runs,
               std::size_t& count) const;
  void fill_bins();

  PointCloud points_;
  std::vector<std::uint32_t> order_;
  std::vector<Column> columns_;  // columns_x_ * columns_y_, and one more
  std::vector<std::uint32_t> bins_;
  std::vector<std::uint32_t> sorted_;  // memory for build()
  std::vector<std::uint32_t> column_;  // of each point of the cloud; memory for build()
  double radius_ = 0;
  float width_ = 0;  // of a column [m]
  float inverse_width_ = 0;
  float inverse_bin_ = 0;  // bins a metre
  float min_x_ = 0;
  float min_y_ = 0;
  float min_z_ = 0;
  std::int64_t columns_x_ = 0;
  std::int64_t columns_y_ = 0;
};

}  // namespace cvo_slam
