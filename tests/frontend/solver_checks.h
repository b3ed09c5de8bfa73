// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "cvo_slam/frontend/registration.h"
#include "cvo_slam/tests/frontend/test_clouds.h"

namespace cvo_slam {

/// Returns options whose every number is set here, with tolerances far below what is asserted.
inline RegistrationOptions exact_options(Solver solver, ColorKernel color,
                                         std::vector<double> length_scales) {
  RegistrationOptions options;
  options.solver = solver;
  options.kernel.sigma = 0.1;
  options.kernel.sparsification = 1e-3;
  options.kernel.color_kernel = color;
  options.kernel.ray_noise = 0;  // the flow takes balls
  options.kernel.surfaces = false;
  options.kernel.color_scale = 80;
  options.kernel.gradient_scale = 80;
  options.length_scales = std::move(length_scales);
  options.judged_length_scale = options.length_scales.back();
  options.max_iterations = {5000};
  options.tolerance = 1e-7;
  options.depth_noise = 0;
  options.information_scale = 1;
  options.flow.min_step = 1e-8;
  options.flow.min_gradient = 0;
  return options;
}

/// Returns a cloud around the origin, where rotation and translation hardly depend on each other
/// and the first-order solvers converge quickly.
inline PointCloud centred_cloud(std::size_t n, unsigned seed) {
  return transformed(random_cloud(n, seed), SE3(Matrix3::Identity(), {0, 0, -1.5}));
}

/// Returns a seeded motion of at most `translation` [m] and `rotation` [rad] along and about each
/// axis.
inline SE3 random_motion(double translation, double rotation, unsigned seed) {
  std::mt19937 rng(seed);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  Vector6 xi;
  for (int k = 0; k < 6; ++k) xi[k] = unit(rng) * (k < 3 ? translation : rotation);
  return SE3::exp(xi);
}

/// Returns the cloud with noise: up to 5 mm in positions and up to 10 grey levels in colours.
inline PointCloud noisy(PointCloud cloud, unsigned seed) {
  std::mt19937 rng(seed);
  std::uniform_real_distribution<float> unit(-1.0F, 1.0F);
  for (auto* axis : {&cloud.x, &cloud.y, &cloud.z}) {
    for (float& value : *axis) value += 0.005F * unit(rng);
  }
  for (auto& feature : cloud.features) {
    for (float& value : feature) value += 10 * unit(rng);
  }
  return cloud;
}

inline void expect_near(const SE3& a, const SE3& b, double translation, double rotation) {
  const SE3 difference = a.inverse() * b;
  EXPECT_LT(difference.translation().norm(), translation);
  EXPECT_LT(difference.angle(), rotation);
}

/// 0.1 mm and 0.01 degrees: below anything that a depth camera resolves.
inline void expect_agreement(const SE3& a, const SE3& b) {
  expect_near(a, b, 1e-4, 0.01 * M_PI / 180);
}

}  // namespace cvo_slam
