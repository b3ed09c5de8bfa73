// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <ceres/internal/eigen.h>
#include <ceres/manifold_test_utils.h>
#include <gtest/gtest.h>

#include "cvo_slam/backend/between_factor_internal.h"
#include "cvo_slam/bench/graph_samples.h"

namespace cvo_slam {
namespace {

TEST(PoseManifold, MeetsTheInvariantsOfCeres) {
  using namespace ceres;  // the macro's own need
  std::mt19937 rng(1);
  const PoseManifold manifold;
  for (int i = 0; i < 50; ++i) {
    const SE3 T_x = SE3::exp(random_tangent(rng, 3, 1));
    const Vector6 step = random_tangent(rng, 1, i < 10 ? 1e-9 : 0.5);
    const Vector x = to_vector(T_x);
    Vector y = to_vector(T_x * SE3::exp(random_tangent(rng, 1, 0.5)));
    if (y.tail<4>().dot(x.tail<4>()) < 0)
      y.tail<4>() *= -1;  // the same pose; Plus answers this one
    const Vector delta = step;
    // The macro differentiates numerically.
    EXPECT_THAT_MANIFOLD_INVARIANTS_HOLD(manifold, x, delta, y, 1e-8);
  }
}

TEST(PoseManifold, IsTheRightPerturbationOfSe3) {
  std::mt19937 rng(2);
  const PoseManifold manifold;
  for (int i = 0; i < 20; ++i) {
    const SE3 T = SE3::exp(random_tangent(rng, 3, 1));
    const Vector6 xi = random_tangent(rng, 1, 0.5);
    const PoseVector x = to_vector(T);
    PoseVector moved;
    ASSERT_TRUE(manifold.Plus(x.data(), xi.data(), moved.data()));
    EXPECT_LT((to_pose(moved).matrix() - (T * SE3::exp(xi)).matrix()).norm(), 1e-13);
    Vector6 back;
    ASSERT_TRUE(manifold.Minus(moved.data(), x.data(), back.data()));
    EXPECT_LT((back - xi).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace cvo_slam
