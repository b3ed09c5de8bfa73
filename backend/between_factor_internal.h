// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "cvo_slam/core/se3.h"

namespace cvo_slam {

/// A pose as Ceres sees it: [p; q] with the quaternion as x, y, z, w.
using PoseVector = Eigen::Matrix<double, 7, 1, Eigen::DontAlign>;
using PoseJacobian = Eigen::Matrix<double, 6, 7, Eigen::RowMajor | Eigen::DontAlign>;

[[nodiscard]] PoseVector to_vector(const SE3& pose);
[[nodiscard]] SE3 to_pose(const PoseVector& vector);

/// A residual with its derivatives by the seven values of either pose, all whitened: |r|^2 is the
/// squared error.
struct LinearizedEdge {
  Vector6 residual;
  PoseJacobian jacobian_a;
  PoseJacobian jacobian_b;
};

/// One measurement: the residual of core/pose_graph_cost.h times the square root of its
/// information.
class BetweenFactor {
 public:
  BetweenFactor(const SE3& T_a_b, const Matrix6& information);

  [[nodiscard]] Vector6 residual(const PoseVector& a, const PoseVector& b) const;

  /// With D = dr / dxi for a right perturbation T exp(xi) of one pose and M the derivative of
  /// PoseManifold::Minus, the derivative by its seven values is taken as D M. It differs from the
  /// plain one only across the manifold, where nothing moves.
  void linearize(const PoseVector& a, const PoseVector& b, LinearizedEdge& out) const;

 private:
  Vector3 p_a_b_;
  Eigen::Quaterniond q_a_b_;
  Eigen::Matrix<double, 6, 6> square_root_;
};

}  // namespace cvo_slam
