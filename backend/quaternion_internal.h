// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include <Eigen/Geometry>

namespace cvo_slam {

/// The matrix G of q (0, v) = G v, with the product as (x, y, z, w). G^T G is the identity.
inline Eigen::Matrix<double, 4, 3> right_product_columns(const Eigen::Quaterniond& q) {
  Eigen::Matrix<double, 4, 3> G;
  G << q.w(), -q.z(), q.y(),  //
      q.z(), q.w(), -q.x(),   //
      -q.y(), q.x(), q.w(),   //
      -q.x(), -q.y(), -q.z();
  return G;
}

/// The quaternion of the rotation by |w| [rad] about w.
inline Eigen::Quaterniond exp_quaternion(const Eigen::Vector3d& w) {
  const double half = w.norm() / 2;
  // Half of sin(half) / half; the series is exact to rounding where the quotient is not.
  const double scale = half < 1e-4 ? 0.5 * (1 - half * half / 6) : 0.5 * std::sin(half) / half;
  return {std::cos(half), scale * w.x(), scale * w.y(), scale * w.z()};
}

}  // namespace cvo_slam
