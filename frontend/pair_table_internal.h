// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "cvo_slam/core/parallel.h"
#include "cvo_slam/core/point_cloud.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/frontend/neighbor_grid_internal.h"
#include "cvo_slam/frontend/registration.h"

namespace cvo_slam {

/// The neighbours of some moving points, one list after the other, in the order of a query.
struct NeighborLists {
  std::vector<float> x, y, z;        ///< position of the fixed point [m]; more entries than used
  std::vector<float> c;              ///< inner product of the labels
  std::vector<std::uint32_t> count;  ///< neighbours of each moving point
  std::size_t used = 0;              ///< entries in use
};

/// The pairs of a moving cloud with a grid's points, laid out for SIMD: groups of kLanes moving
/// points, a row of a group holding one neighbour of each. Labels are compared once, when the table
/// is made; a pose near that one only has to look at the table (a Verlet list).
class PairTable {
 public:
  static constexpr std::size_t kLanes = 16;  ///< floats in the widest vector
  using Lanes = std::array<float, kLanes>;

  /// One neighbour of each of a group's moving points. If a point has fewer than others, c is 0 and
  /// the position far away.
  struct alignas(64) Row {
    Lanes x;
    Lanes y;
    Lanes z;
    Lanes c;
  };
  struct alignas(64) Group {
    Lanes x;  ///< positions of the moving points, in their own frame [m]
    Lanes y;
    Lanes z;
    std::array<Lanes, 6> P;  ///< ell^2 times the kernels' precision: xx, xy, xz, yy, yz, zz
    std::size_t row_begin;
    std::size_t row_end;
  };

  /// Finds the neighbours of the first `count` moving points within the grid's radius, which must
  /// exceed the kernel's support. Points without neighbours are left out. The memory is kept for
  /// the next call.
  void build(const NeighborGrid& grid, const PointCloud& moving, std::size_t count,
             const SE3& T_fixed_moving, const KernelOptions& kernel, double length_scale,
             const Executor& executor);
  /// Takes over the same clouds with another kernel; the moving points may have moved a little,
  /// their labels may not have changed. Returns false if the table does not hold these numbers of
  /// points, or if its radius is too small or much too large: it is as it was then.
  [[nodiscard]] bool reuse(const NeighborGrid& grid, const PointCloud& moving, std::size_t count,
                           const KernelOptions& kernel, double length_scale);
  /// Makes covers() false until the next build().
  void clear() { built_ = false; }

  /// Returns true if no pair inside the support at this pose is missing.
  [[nodiscard]] bool covers(const SE3& T_fixed_moving) const;

  /// Returns true if the kernels are not all balls.
  [[nodiscard]] bool has_shapes() const { return has_shapes_; }
  [[nodiscard]] const std::vector<Group>& groups() const { return groups_; }
  [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }

 private:
  void group_by_count(std::size_t count);
  void fill();
  void set_points(const PointCloud& moving, const KernelOptions& kernel, double length_scale);

  std::vector<NeighborLists> lists_;       // one a chunk of moving points
  std::vector<std::uint32_t> order_;       // moving points, those with most neighbours first
  std::vector<std::uint32_t> list_begin_;  // of each moving point in its chunk's lists
  std::vector<std::uint32_t> bucket_;      // for counting
  std::vector<Group> groups_;
  std::vector<Row> rows_;
  bool built_ = false;
  bool has_shapes_ = false;
  std::size_t fixed_count_ = 0;
  std::size_t moving_count_ = 0;
  std::vector<Vector3> positions_;  // of all moving points, in their own frame
  double radius_ = 0;               // within which neighbours were searched [m]
  SE3 T_fixed_moving_;
  double skin_ = 0;       // a pose that moves no point further than this is covered [m]
  double max_range_ = 0;  // of the moved points [m]
};

}  // namespace cvo_slam
