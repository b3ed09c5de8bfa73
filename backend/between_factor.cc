// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>

#include "cvo_slam/backend/between_factor_internal.h"
#include "cvo_slam/core/pose_graph.h"

namespace cvo_slam {
namespace {

using Quaternion = Eigen::Quaterniond;
using PoseJacobian = Eigen::Matrix<double, 6, 7, Eigen::RowMajor>;

Vector3 position(const double* pose) { return Eigen::Map<const Vector3>(pose); }
Quaternion orientation(const double* pose) { return Quaternion(pose + 3); }

/// Returns the matrix G with q (0, v) = G v, the product as (x, y, z, w). G^T G is the identity.
Eigen::Matrix<double, 4, 3> right_product_columns(const Quaternion& q) {
  Eigen::Matrix<double, 4, 3> G;
  G << q.w(), -q.z(), q.y(),  //
      q.z(), q.w(), -q.x(),   //
      -q.y(), q.x(), q.w(),   //
      -q.x(), -q.y(), -q.z();
  return G;
}

/// Returns q_ab q_est^-1 with w >= 0.
Quaternion rotation_error(const Quaternion& q_a_b, const Quaternion& q_a, const Quaternion& q_b) {
  Quaternion e = q_a_b * q_b.conjugate() * q_a;
  if (e.w() < 0) e.coeffs() *= -1;
  return e;
}

/// Writes the derivative by the seven values of a pose, from those by its position and by a
/// rotation on the right, if there is a place for it.
void write_jacobian(const Eigen::Matrix<double, 6, 3>& by_position,
                    const Eigen::Matrix<double, 6, 3>& by_rotation, const Quaternion& q,
                    double* out) {
  if (out == nullptr) return;
  Eigen::Map<PoseJacobian> jacobian(out);
  const Eigen::Matrix<double, 3, 4> rotation_by_values = 2 * right_product_columns(q).transpose();
  jacobian.leftCols<3>() = by_position;
  jacobian.rightCols<4>() = by_rotation * rotation_by_values;
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

bool BetweenFactor::Evaluate(const double* const* poses, double* residual,
                             double** jacobians) const {
  const Quaternion q_a = orientation(poses[0]);
  const Quaternion q_b = orientation(poses[1]);
  const Vector3 p_world_a_b = position(poses[1]) - position(poses[0]);
  const Quaternion e = rotation_error(q_a_b_, q_a, q_b);
  Eigen::Map<Vector6> whitened(residual);
  Eigen::Matrix<double, 6, 1> r;
  if (jacobians == nullptr) {
    r << q_a.conjugate() * p_world_a_b - p_a_b_, 2 * e.vec();
    whitened = square_root_ * r;
    return true;
  }
  const Matrix3 R_a_world = q_a.toRotationMatrix().transpose();
  const Matrix3 R_a_b = R_a_world * q_b.toRotationMatrix();
  const Vector3 p_a_b = R_a_world * p_world_a_b;
  r << p_a_b - p_a_b_, 2 * e.vec();
  whitened = square_root_ * r;

  // e (1, w / 2) = e + (s w + u x w, ...) / 2 with e = (s, u): how a rotation w of frame a changes
  // e.
  const Matrix3 turn = e.w() * Matrix3::Identity() + skew(e.vec());
  const auto S_p = square_root_.leftCols<3>();
  const auto S_r = square_root_.rightCols<3>();
  const Eigen::Matrix<double, 6, 3> by_position = S_p * R_a_world;
  const Eigen::Matrix<double, 6, 3> by_turn = S_r * turn;
  write_jacobian(-by_position, S_p * skew(p_a_b) + by_turn, q_a, jacobians[0]);
  write_jacobian(by_position, by_turn * -R_a_b, q_b, jacobians[1]);
  return true;
}

}  // namespace cvo_slam
