// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/tests/frontend/reference_align.h"

#include <cmath>

#include <Eigen/Geometry>

namespace cvo_slam {

double reference_objective(const PointCloud& fixed, const PointCloud& moving,
                           const SE3& T_fixed_moving, const KernelOptions& kernel,
                           double length_scale) {
  double sum = 0;
  for (std::size_t i = 0; i < fixed.size(); ++i) {
    for (std::size_t j = 0; j < moving.size(); ++j) {
      const Vector3 d = fixed.position(i) - T_fixed_moving * moving.position(j);
      const double k = kernel.sigma * kernel.sigma *
                       std::exp(-d.squaredNorm() / (2 * length_scale * length_scale));
      if (k > kernel.sparsification) sum += label_product(kernel, fixed, i, moving, j) * k;
    }
  }
  return sum;
}

SE3 reference_align(const PointCloud& fixed, const PointCloud& moving,
                    const SE3& T_fixed_moving_init, const KernelOptions& kernel,
                    double length_scale) {
  constexpr int kMaxSteps = 20000;
  constexpr double kTolerance = 1e-9;
  const double ell2 = length_scale * length_scale;
  SE3 T = T_fixed_moving_init;
  for (int step = 0; step < kMaxSteps; ++step) {
    // The flow in a metric that weighs rotations as points 1 m away: dF/d(v, omega) of a left
    // perturbation, and the sum of weights as the curvature that sets the step's length (one
    // majorise-minimise step of each part by itself).
    Vector3 v = Vector3::Zero();
    Vector3 omega = Vector3::Zero();
    double curvature = 0;
    for (std::size_t i = 0; i < fixed.size(); ++i) {
      for (std::size_t j = 0; j < moving.size(); ++j) {
        const Vector3 z = T * moving.position(j);
        const Vector3 d = fixed.position(i) - z;
        const double k = kernel.sigma * kernel.sigma * std::exp(-d.squaredNorm() / (2 * ell2));
        if (k <= kernel.sparsification) continue;
        const double w = label_product(kernel, fixed, i, moving, j) * k;
        v += w * d;
        omega += w * z.cross(d);
        curvature += w * (1 + z.squaredNorm());
      }
    }
    const Vector6 xi = (Vector6() << v, omega).finished() / curvature;
    T = SE3::exp(xi) * T;
    if (xi.norm() < kTolerance) break;
  }
  return T;
}

}  // namespace cvo_slam
