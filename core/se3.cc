// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/core/se3.h"

#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>

namespace cvo_slam {
namespace {

/// Below this angle the closed forms lose digits to cancellation, and the Taylor series, cut after
/// the fourth term, are exact to rounding. [rad]
constexpr double kSmallAngle = 0.1;

/// The scalar functions of the angle th in the closed forms of exp and log.
struct AngleCoefficients {
  double a;  ///< sin(th) / th
  double b;  ///< (1 - cos(th)) / th^2
  double c;  ///< (th - sin(th)) / th^3
  double d;  ///< (1 - a / (2 b)) / th^2, for the inverse Jacobian of SO(3)
};

AngleCoefficients angle_coefficients(double th) {
  const double t2 = th * th;
  if (th < kSmallAngle) {
    return {1 - t2 / 6 * (1 - t2 / 20 * (1 - t2 / 42 * (1 - t2 / 72))),
            (1 - t2 / 12 * (1 - t2 / 30 * (1 - t2 / 56))) / 2,
            (1 - t2 / 20 * (1 - t2 / 42 * (1 - t2 / 72))) / 6,
            (1 + t2 / 60 * (1 + t2 / 42 * (1 + t2 / 40))) / 12};
  }
  const double half = std::sin(th / 2);
  const double a = std::sin(th) / th;
  const double b = 2 * half * half / t2;
  const double c = (1 - a) / t2;
  return {a, b, c, (1 - a / (2 * b)) / t2};
}

Matrix3 so3_left_jacobian(const Vector3& w) {
  const auto k = angle_coefficients(w.norm());
  const Matrix3 W = skew(w);
  return Matrix3::Identity() + k.b * W + k.c * W * W;
}

Matrix3 so3_left_jacobian_inverse(const Vector3& w) {
  const auto k = angle_coefficients(w.norm());
  const Matrix3 W = skew(w);
  return Matrix3::Identity() - 0.5 * W + k.d * W * W;
}

}  // namespace

Matrix6 inverse_of_spd(const Matrix6& matrix) {
  const AlignedMatrix6 inverse = AlignedMatrix6(matrix).llt().solve(AlignedMatrix6::Identity());
  return 0.5 * (inverse + inverse.transpose());
}

Matrix3 skew(const Vector3& w) {
  Matrix3 W;
  W << 0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0;
  return W;
}

Matrix3 so3_exp(const Vector3& w) {
  const auto k = angle_coefficients(w.norm());
  const Matrix3 W = skew(w);
  return Matrix3::Identity() + k.a * W + k.b * W * W;
}

Vector3 so3_log(const Matrix3& rotation) {
  const Eigen::Quaterniond q(rotation);
  // Through the quaternion: exact near 0 (vec(q) -> w / 2) and near pi (w -> 0) alike.
  const double sign = q.w() < 0 ? -1.0 : 1.0;
  const double sin_half = q.vec().norm();
  const double cos_half = sign * q.w();
  if (sin_half < 1e-12) return 2.0 * sign * q.vec() / cos_half;
  return sign * (2.0 * std::atan2(sin_half, cos_half) / sin_half) * q.vec();
}

SE3 SE3::from_quaternion(double qx, double qy, double qz, double qw, const Vector3& translation) {
  return {Eigen::Quaterniond(qw, qx, qy, qz).normalized().toRotationMatrix(), translation};
}

SE3 SE3::from_matrix(const Eigen::Matrix4d& matrix) {
  const Matrix3 block = matrix.topLeftCorner<3, 3>();
  const Eigen::JacobiSVD<Matrix3> svd(block, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Matrix3 U = svd.matrixU();
  if ((U * svd.matrixV().transpose()).determinant() < 0) U.col(2) *= -1;
  return {U * svd.matrixV().transpose(), matrix.topRightCorner<3, 1>()};
}

SE3 SE3::exp(const Vector6& tangent) {
  const Vector3 w = tangent.tail<3>();
  return {so3_exp(w), so3_left_jacobian(w) * tangent.head<3>()};
}

Eigen::Vector4d SE3::quaternion() const {
  const Eigen::Quaterniond q(rotation_);
  return q.w() < 0 ? Eigen::Vector4d(-q.coeffs()) : Eigen::Vector4d(q.coeffs());
}

Eigen::Matrix4d SE3::matrix() const {
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  m.topLeftCorner<3, 3>() = rotation_;
  m.topRightCorner<3, 1>() = translation_;
  return m;
}

double SE3::angle() const { return so3_log(rotation_).norm(); }

SE3 SE3::inverse() const {
  return {rotation_.transpose(), -(rotation_.transpose() * translation_)};
}

Vector6 SE3::log() const {
  const Vector3 w = so3_log(rotation_);
  Vector6 xi;
  xi << so3_left_jacobian_inverse(w) * translation_, w;
  return xi;
}

Matrix6 SE3::adjoint() const {
  Matrix6 ad = Matrix6::Zero();
  ad.topLeftCorner<3, 3>() = rotation_;
  ad.topRightCorner<3, 3>() = skew(translation_) * rotation_;
  ad.bottomRightCorner<3, 3>() = rotation_;
  return ad;
}

SE3 SE3::normalized() const {
  return {Eigen::Quaterniond(rotation_).normalized().toRotationMatrix(), translation_};
}

SE3 interpolate(const SE3& a, const SE3& b, double s) {
  return a * SE3::exp(s * (a.inverse() * b).log());
}

}  // namespace cvo_slam
