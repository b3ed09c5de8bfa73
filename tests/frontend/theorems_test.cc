// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The theorems of the paper (Ghaffari et al., RSS 2019), with sparsification off.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "cvo_slam/frontend/objective_internal.h"
#include "cvo_slam/frontend/solvers_internal.h"
#include "cvo_slam/tests/frontend/evaluate.h"
#include "cvo_slam/tests/frontend/reference_align.h"
#include "cvo_slam/tests/frontend/test_clouds.h"

namespace cvo_slam {
namespace {

constexpr double kScale = 0.2;

KernelOptions no_sparsification() {
  KernelOptions kernel;
  kernel.sparsification = 1e-9;
  return kernel;
}

class Theorem : public testing::Test {
 protected:
  [[nodiscard]] double f(const PointCloud& a, const PointCloud& b, const SE3& T) const {
    return reference_objective(a, b, T, kernel_, kScale);
  }
  [[nodiscard]] double norm(const PointCloud& a) const { return std::sqrt(f(a, a, SE3())); }

  KernelOptions kernel_ = no_sparsification();
  PointCloud x_ = random_cloud(80, 1);
  PointCloud z_ = random_cloud(50, 2);
};

TEST_F(Theorem, IdentityIsAFixedPointForEqualClouds) {
  Objective objective;
  objective.build(x_, kernel_, kScale);
  const ObjectiveValue value = evaluate(objective, x_, SE3());
  const FlowDirection flow = flow_direction(value, 7, 7);
  // Terms cancel in pairs up to the rounding of single precision.
  EXPECT_LT(flow.omega.norm(), 2e-6 * value.inner_product / kScale);
  EXPECT_LT(flow.v.norm(), 2e-6 * value.inner_product / kScale);
}

TEST_F(Theorem, IdentityIsTheGlobalMaximumForEqualClouds) {
  std::mt19937 rng(3);
  std::normal_distribution<double> normal;
  const double maximum = f(x_, x_, SE3());
  for (int i = 0; i < 200; ++i) {
    Vector6 xi;
    for (int k = 0; k < 6; ++k) xi[k] = 0.5 * normal(rng);
    EXPECT_LT(f(x_, x_, SE3::exp(xi)), maximum);
  }
}

TEST_F(Theorem, CosThetaLiesInTheUnitIntervalAndRisesWithF) {
  double last_f = 0;
  double last_cosine = 0;
  for (const double distance : {0.4, 0.3, 0.2, 0.1, 0.0}) {
    const SE3 T = motion(distance, 0, 0, 0, 0, distance);
    const double inner = f(x_, x_, T);
    const double cosine = inner / (norm(x_) * norm(x_));
    EXPECT_GE(cosine, 0);
    EXPECT_LE(cosine, 1 + 1e-12);
    EXPECT_GT(inner, last_f);
    EXPECT_GT(cosine, last_cosine);
    last_f = inner;
    last_cosine = cosine;
  }
  EXPECT_NEAR(last_cosine, 1, 1e-12);
}

TEST_F(Theorem, IsometriesPreserveTheNorm) {
  const PointCloud moved = transformed(z_, motion(0.3, -0.2, 0.5, 0.4, 1.0, -0.7));
  EXPECT_NEAR(norm(moved), norm(z_), 1e-5 * norm(z_));  // positions are single precision
}

TEST_F(Theorem, CloudsNeedNotHaveEqualSizes) {
  // A cloud and every third of its points: the pose is found all the same.
  std::vector<std::size_t> third;
  for (std::size_t i = 0; i < x_.size(); i += 3) third.push_back(i);
  const SE3 T = motion(0.02, -0.03, 0.01, 0.02, 0.03, -0.02);
  const SE3 found =
      reference_align(x_, transformed(subset(x_, third), T.inverse()), SE3(), kernel_, 0.03);
  EXPECT_LT((found.inverse() * T).log().norm(), 1e-3);
}

TEST_F(Theorem, TheOrderOfThePointsDoesNotMatter) {
  std::vector<std::size_t> order(z_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::shuffle(order.begin(), order.end(), std::mt19937(4));
  const SE3 T = motion(0.05, 0.02, 0, 0, 0.1, 0);
  const double inner = f(x_, z_, T);
  EXPECT_NEAR(f(x_, subset(z_, order), T), inner, 1e-13 * inner);
  Objective objective;
  objective.build(x_, kernel_, kScale);
  EXPECT_NEAR(evaluate(objective, subset(z_, order), T).inner_product, inner, 2e-6 * inner);
}

TEST_F(Theorem, FlowStepsAscend) {
  Objective level;
  level.build(x_, kernel_, kScale);
  const Executor executor;
  PairTable pairs;
  PoseObjective objective(level, x_, x_.size(), pairs, executor);
  const SE3 T = motion(0.05, -0.03, 0.02, 0.05, -0.05, 0.1);
  const FlowDirection flow = flow_direction(objective.evaluate(T), 7, 7);
  const auto t = smallest_positive_stationary_point(step_expansion(objective, T, flow));
  ASSERT_TRUE(t);
  const Vector6 step = (Vector6() << -*t * flow.v, -*t * flow.omega).finished();
  EXPECT_GT(f(x_, x_, SE3::exp(step) * T), f(x_, x_, T));
}

}  // namespace
}  // namespace cvo_slam
