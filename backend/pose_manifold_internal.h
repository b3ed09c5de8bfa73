// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ceres/manifold.h>

namespace cvo_slam {

/// SE(3) for Ceres: a pose is [p; q] with the quaternion as x, y, z, w (PoseVector), a tangent is
/// [translation; rotation] on the right, as everywhere in this library:
/// Plus(T, xi) = T exp(xi), Minus(T', T) = log(T^-1 T').
class PoseManifold final : public ceres::Manifold {
 public:
  [[nodiscard]] int AmbientSize() const override { return 7; }
  [[nodiscard]] int TangentSize() const override { return 6; }
  bool Plus(const double* x, const double* delta, double* x_plus_delta) const override;
  bool PlusJacobian(const double* x, double* jacobian) const override;
  bool Minus(const double* y, const double* x, double* y_minus_x) const override;
  bool MinusJacobian(const double* x, double* jacobian) const override;
};

}  // namespace cvo_slam
