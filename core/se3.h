// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <numbers>

#include <Eigen/Core>

namespace cvo_slam {

/// A position, a direction or a rotation vector.
using Vector3 = Eigen::Vector3d;
/// A tangent vector [translation; rotation]; unaligned as Matrix6 is.
using Vector6 = Eigen::Matrix<double, 6, 1, Eigen::DontAlign>;
/// A rotation, or another 3x3 matrix.
using Matrix3 = Eigen::Matrix3d;
/// Unaligned on purpose: the layout of public structs must not depend on the embedder's -m flags.
using Matrix6 = Eigen::Matrix<double, 6, 6, Eigen::DontAlign>;
/// The same matrix with Eigen's alignment, for computations; not for members of public structs.
using AlignedMatrix6 = Eigen::Matrix<double, 6, 6>;

/// Returns the inverse of a symmetric positive definite matrix, symmetric too: the information of a
/// covariance, and the reverse.
[[nodiscard]] Matrix6 inverse_of_spd(const Matrix6& matrix);

/// One radian in degrees [deg/rad], for output to people: all angles inside are in radians.
inline constexpr double kDegrees = 180 / std::numbers::pi;

/// One metre in millimetres [mm/m], for output to people.
inline constexpr double kMillimetres = 1000;

/// Returns the skew-symmetric matrix w^ with w^ p = w x p.
Matrix3 skew(const Vector3& w);

/// A rigid motion: the pose T_a_b maps points of frame b to frame a, p_a = T_a_b * p_b.
///
/// Tangent vectors are [translation; rotation] (metres, radians); exp and log are those of the
/// group SE(3), not of R^3 x SO(3). Perturbations act on the right, T * exp(xi), unless a name says
/// otherwise. Rotation and translation are kept as a 3x3 matrix and a 3-vector, neither of which
/// Eigen aligns, so that the type's layout is the same under any compiler flags.
class SE3 {
 public:
  /// The identity.
  SE3() = default;
  /// `rotation` must be orthonormal with determinant +1; from_matrix() rounds one that is not.
  SE3(const Matrix3& rotation, const Vector3& translation)
      : rotation_(rotation), translation_(translation) {}

  /// Takes a quaternion in the order of TUM files, and normalises it.
  static SE3 from_quaternion(double qx, double qy, double qz, double qw,
                             const Vector3& translation);
  /// Rounds the upper left 3x3 block to the nearest rotation (SVD).
  static SE3 from_matrix(const Eigen::Matrix4d& matrix);
  /// Returns the exponential of a tangent vector; the inverse of log().
  static SE3 exp(const Vector6& tangent);

  /// Returns the rotation matrix, orthonormal up to rounding.
  [[nodiscard]] const Matrix3& rotation() const { return rotation_; }
  /// Returns the position of the origin of frame b in frame a [m].
  [[nodiscard]] const Vector3& translation() const { return translation_; }
  /// Returns the unit quaternion (x, y, z, w) with w >= 0.
  [[nodiscard]] Eigen::Vector4d quaternion() const;
  /// Returns the homogeneous matrix; its last row is 0, 0, 0, 1.
  [[nodiscard]] Eigen::Matrix4d matrix() const;
  /// Returns the rotation angle in [0, pi] [rad].
  [[nodiscard]] double angle() const;

  /// Returns T_b_a of T_a_b.
  [[nodiscard]] SE3 inverse() const;
  /// Returns the tangent vector whose exponential is this pose; its rotation part is at most pi
  /// long.
  [[nodiscard]] Vector6 log() const;
  /// Returns the matrix Ad with T exp(xi) T^-1 = exp(Ad xi).
  [[nodiscard]] Matrix6 adjoint() const;
  /// Returns the pose with its rotation made orthonormal again; removes what rounding accumulates
  /// over long products.
  [[nodiscard]] SE3 normalized() const;

  /// Returns T_a_c of T_a_b and `other`, T_b_c.
  SE3 operator*(const SE3& other) const {
    return {rotation_ * other.rotation_, rotation_ * other.translation_ + translation_};
  }
  /// Returns a point of frame b in frame a.
  Vector3 operator*(const Vector3& point) const { return rotation_ * point + translation_; }

 private:
  Matrix3 rotation_ = Matrix3::Identity();
  Vector3 translation_ = Vector3::Zero();
};

/// Returns the exponential of SO(3): the rotation about the axis w by the angle |w| [rad].
Matrix3 so3_exp(const Vector3& w);
/// Returns the logarithm of SO(3): the rotation vector [rad], at most pi long.
Vector3 so3_log(const Matrix3& rotation);

/// Returns the pose at `s` on the geodesic from a (s = 0) to b (s = 1): a exp(s log(a^-1 b)).
SE3 interpolate(const SE3& a, const SE3& b, double s);

}  // namespace cvo_slam
