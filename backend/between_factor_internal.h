// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <ceres/manifold.h>
#include <ceres/product_manifold.h>
#include <ceres/sized_cost_function.h>

#include "cvo_slam/core/se3.h"

namespace cvo_slam {

/// A pose as Ceres sees it: [p; q] with the quaternion as x, y, z, w.
using PoseVector = Eigen::Matrix<double, 7, 1, Eigen::DontAlign>;

[[nodiscard]] PoseVector to_vector(const SE3& pose);
[[nodiscard]] SE3 to_pose(const PoseVector& vector);

/// The manifold of such poses: a step moves the position in the world and rotates in the world.
using PoseManifold =
    ceres::ProductManifold<ceres::EuclideanManifold<3>, ceres::EigenQuaternionManifold>;

/// The residual between_residual() of one measurement times the square root of its information, as
/// a function of two poses (PoseVector): |r|^2 is the squared error of the edge.
///
/// The derivative by the quaternion q of a pose is D 2 G^T, where D is the derivative by a rotation
/// on the right and q (0, v) = G v. It differs from the plain derivative only across the manifold,
/// where nothing moves.
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
