// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "cvo_slam/core/parallel.h"
#include "cvo_slam/core/point_cloud.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/frontend/neighbor_grid_internal.h"
#include "cvo_slam/frontend/pair_table_internal.h"
#include "cvo_slam/frontend/registration.h"

namespace cvo_slam {

/// The objective F(T) = sum_ij c_ij k(x_i, T z_j) of CVO and its derivatives with respect to a left
/// perturbation (v, w) of T, q_j = T z_j, r = x_i - q_j, w_ij = c_ij k_ij, J = [I, -q^].
struct ObjectiveValue {
  /// sum c max(k - sparsification, 0): continuous in spite of the hard threshold, so that it can be
  /// compared between poses; its derivatives are those of F inside the support.
  double value = 0;
  double inner_product = 0;  ///< F = sum w
  Vector6 gradient = Vector6::Zero();
  /// The negative Hessian: sum J^T (w / ell^2 P - w / ell^4 p p^T) J and the curvature of exp, with
  /// P = I and p = r where the kernel is a ball (PairSums).
  Matrix6 hessian = Matrix6::Zero();
  /// The Hessian of the majorising least squares, sum w / ell^2 J^T P J: always semi-definite.
  Matrix6 majorizer = Matrix6::Zero();
  std::size_t matched = 0;  ///< moving points with a fixed point inside the support
};

/// One fixed cloud at one length scale.
class Objective {
 public:
  /// Takes the first `count` points of `fixed`; `by_depth` holds all of them.
  void build(const PointCloud& fixed, const PointsByDepth& by_depth, std::size_t count,
             const KernelOptions& kernel, double length_scale);
  void build(const PointCloud& fixed, const KernelOptions& kernel, double length_scale);

  [[nodiscard]] double length_scale() const { return length_scale_; }
  [[nodiscard]] const KernelOptions& kernel() const { return kernel_; }
  [[nodiscard]] const NeighborGrid& grid() const { return grid_; }

 private:
  KernelOptions kernel_;
  double length_scale_ = 0;
  NeighborGrid grid_;
};

/// Returns |f|^2 of a cloud, whose points are in the grid, with this kernel and length scale.
[[nodiscard]] double squared_norm(const NeighborGrid& grid, const PointCloud& cloud,
                                  const KernelOptions& kernel, double length_scale,
                                  const Executor& executor);

/// The objective as a function of the pose of one moving cloud. Pairs are searched again if a pose
/// leaves the surroundings of the last search.
class PoseObjective {
 public:
  /// Uses the first `count` moving points. All arguments must outlive the object. `pairs` is memory
  /// to use, and the pairs in it serve again if they can: clear() it before other clouds.
  PoseObjective(const Objective& objective, const PointCloud& moving, std::size_t count,
                PairTable& pairs, const Executor& executor);

  [[nodiscard]] const KernelOptions& kernel() const { return objective_.kernel(); }
  [[nodiscard]] double length_scale() const { return objective_.length_scale(); }
  [[nodiscard]] ObjectiveValue evaluate(const SE3& T_fixed_moving);
  /// Returns the pairs at this pose.
  [[nodiscard]] const PairTable& pairs(const SE3& T_fixed_moving);

 private:
  const Objective& objective_;
  const PointCloud& moving_;
  std::size_t count_;
  PairTable& pairs_;
  const Executor& executor_;
};

}  // namespace cvo_slam
