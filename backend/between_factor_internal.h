// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <ceres/manifold.h>
#include <ceres/sized_cost_function.h>

#include "cvo_slam/core/se3.h"

namespace cvo_slam {

/// A pose as Ceres sees it: [p; q] with the quaternion as x, y, z, w.
using PoseVector = Eigen::Matrix<double, 7, 1, Eigen::DontAlign>;

[[nodiscard]] PoseVector to_vector(const SE3& pose);
[[nodiscard]] SE3 to_pose(const PoseVector& vector);

/// SE(3) for Ceres. The tangent is [translation; rotation] on the right, as everywhere in this
/// library: Plus(T, xi) = T exp(xi), Minus(T', T) = log(T^-1 T').
class PoseManifold final : public ceres::Manifold {
 public:
  [[nodiscard]] int AmbientSize() const override { return 7; }
  [[nodiscard]] int TangentSize() const override { return 6; }
  bool Plus(const double* x, const double* delta, double* x_plus_delta) const override;
  bool PlusJacobian(const double* x, double* jacobian) const override;
  bool Minus(const double* y, const double* x, double* y_minus_x) const override;
  bool MinusJacobian(const double* x, double* jacobian) const override;
};

/// The residual between_residual() of one measurement times the square root of its information, as
/// a function of two poses (PoseVector): |r|^2 is the squared error of the edge.
///
/// With D = dr / dxi for a right perturbation T exp(xi) of one pose and M = PoseManifold's
/// MinusJacobian, the derivative by the seven values of the pose is taken as D M. It differs from
/// the plain derivative only across the manifold, where nothing moves.
class BetweenFactor final : public ceres::SizedCostFunction<6, 7, 7> {
 public:
  BetweenFactor(const SE3& T_a_b, const Matrix6& information);

  bool Evaluate(const double* const* poses, double* residual, double** jacobians) const override;

 private:
  Vector3 p_a_b_;
  Eigen::Quaterniond q_a_b_;
  AlignedMatrix6 square_root_;
};

}  // namespace cvo_slam
