// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>

#include "cvo_slam/backend/between_factor_internal.h"
#include "cvo_slam/backend/pose_manifold_internal.h"
#include "cvo_slam/backend/quaternion_internal.h"

namespace cvo_slam {
namespace {

using Quaternion = Eigen::Quaterniond;

SE3 pose_at(const double* x) { return to_pose(Eigen::Map<const PoseVector>(x)); }

}  // namespace

bool PoseManifold::Plus(const double* x, const double* delta, double* x_plus_delta) const {
  const SE3 step = SE3::exp(Eigen::Map<const Vector6>(delta));
  const Eigen::Map<const Quaternion> q(x + 3);
  Eigen::Map<Vector3> p_plus(x_plus_delta);
  Eigen::Map<Quaternion> q_plus(x_plus_delta + 3);
  p_plus = Eigen::Map<const Vector3>(x) + q * step.translation();
  q_plus = (q * exp_quaternion(Eigen::Map<const Vector3>(delta + 3))).normalized();
  return true;
}

bool PoseManifold::PlusJacobian(const double* x, double* jacobian) const {
  Eigen::Map<Eigen::Matrix<double, 7, 6, Eigen::RowMajor>> J(jacobian);
  const Eigen::Map<const Quaternion> q(x + 3);
  J.setZero();
  J.topLeftCorner<3, 3>() = q.toRotationMatrix();
  J.bottomRightCorner<4, 3>() = 0.5 * right_product_columns(q);
  return true;
}

bool PoseManifold::Minus(const double* y, const double* x, double* y_minus_x) const {
  Eigen::Map<Vector6> xi(y_minus_x);
  xi = (pose_at(x).inverse() * pose_at(y)).log();
  return true;
}

bool PoseManifold::MinusJacobian(const double* x, double* jacobian) const {
  Eigen::Map<Eigen::Matrix<double, 6, 7, Eigen::RowMajor>> J(jacobian);
  const Eigen::Map<const Quaternion> q(x + 3);
  J.setZero();
  J.topLeftCorner<3, 3>() = q.toRotationMatrix().transpose();
  J.bottomRightCorner<3, 4>() = 2 * right_product_columns(q).transpose();
  return true;
}

}  // namespace cvo_slam
