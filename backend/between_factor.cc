// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>

#include "cvo_slam/backend/between_factor_internal.h"
#include "cvo_slam/backend/quaternion_internal.h"
#include "cvo_slam/core/pose_graph.h"

namespace cvo_slam {
namespace {

using Quaternion = Eigen::Quaterniond;

Vector3 position(const PoseVector& pose) { return pose.head<3>(); }
Quaternion orientation(const PoseVector& pose) { return Quaternion(pose.data() + 3); }

/// q_ab q_est^-1 with w >= 0.
Quaternion rotation_error(const Quaternion& q_a_b, const Quaternion& q_a, const Quaternion& q_b) {
  Quaternion e = q_a_b * q_b.conjugate() * q_a;
  if (e.w() < 0) e.coeffs() *= -1;
  return e;
}

}  // namespace

PoseVector to_vector(const SE3& pose) {
  PoseVector vector;
  vector << pose.translation(), pose.quaternion();
  return vector;
}

SE3 to_pose(const PoseVector& vector) {
  return SE3::from_quaternion(vector[3], vector[4], vector[5], vector[6], vector.head<3>());
}

BetweenFactor::BetweenFactor(const SE3& T_a_b, const Matrix6& information)
    : p_a_b_(T_a_b.translation()),
      q_a_b_(Quaternion(T_a_b.rotation())),
      square_root_(square_root_of_information(information)) {}

Vector6 BetweenFactor::residual(const PoseVector& a, const PoseVector& b) const {
  const Quaternion q_a = orientation(a);
  Eigen::Matrix<double, 6, 1> r;
  r << q_a.conjugate() * (position(b) - position(a)) - p_a_b_,
      2 * rotation_error(q_a_b_, q_a, orientation(b)).vec();
  return square_root_ * r;
}

void BetweenFactor::linearize(const PoseVector& a, const PoseVector& b, LinearizedEdge& out) const {
  const Quaternion q_a = orientation(a);
  const Quaternion q_b = orientation(b);
  const Matrix3 R_a_world = q_a.toRotationMatrix().transpose();
  const Matrix3 R_a_b = R_a_world * q_b.toRotationMatrix();
  const Vector3 p_a_b = R_a_world * (position(b) - position(a));
  const Quaternion e = rotation_error(q_a_b_, q_a, q_b);
  Eigen::Matrix<double, 6, 1> r;
  r << p_a_b - p_a_b_, 2 * e.vec();
  out.residual = square_root_ * r;

  // e (1, w / 2) = e + (s w + u x w, ...) / 2 with e = (s, u): how a rotation w of frame a turns
  // it.
  const Matrix3 turn = e.w() * Matrix3::Identity() + skew(e.vec());
  const Eigen::Matrix<double, 3, 4> w_a = 2 * right_product_columns(q_a).transpose();
  const Eigen::Matrix<double, 3, 4> w_b = 2 * right_product_columns(q_b).transpose();
  const auto S_p = square_root_.leftCols<3>();
  const auto S_r = square_root_.rightCols<3>();
  const Eigen::Matrix<double, 6, 3> by_position = S_p * R_a_world;
  const Eigen::Matrix<double, 6, 3> by_turn = S_r * turn;
  const Eigen::Matrix<double, 6, 3> by_rotation_a = S_p * skew(p_a_b) + by_turn;
  const Eigen::Matrix<double, 6, 3> by_rotation_b = by_turn * -R_a_b;
  out.jacobian_a.leftCols<3>() = -by_position;
  out.jacobian_b.leftCols<3>() = by_position;
  out.jacobian_a.rightCols<4>() = by_rotation_a * w_a;
  out.jacobian_b.rightCols<4>() = by_rotation_b * w_b;
}

}  // namespace cvo_slam
