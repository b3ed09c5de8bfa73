// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The steps of the Newton solver at one length scale.
#include <algorithm>
#include <vector>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "cvo_slam/frontend/solvers_internal.h"
#include "cvo_slam/tests/frontend/evaluate.h"
#include "cvo_slam/tests/frontend/test_clouds.h"

namespace cvo_slam {
namespace {

class Newton : public testing::Test {
 protected:
  Newton() {
    kernel_.sparsification = 1e-3;
    stop_.translation = stop_.rotation = 1e-7;
  }

  [[nodiscard]] LevelResult search(const Objective& level, const PointCloud& cloud,
                                   const SE3& T_init, int limit) const {
    const Executor executor;
    PairTable pairs;
    PoseObjective objective(level, cloud, cloud.size(), pairs, executor);
    StopRule stop = stop_;
    stop.max_iterations = limit;
    return newton(objective, T_init, stop);
  }

  /// Returns the results of the search from T_init, stopped after 1, 2, ... iterations.
  [[nodiscard]] std::vector<LevelResult> steps(const PointCloud& cloud, double ell,
                                               const SE3& T_init) const {
    constexpr int kMost = 30;
    Objective objective;
    objective.build(cloud, kernel_, ell);
    std::vector<LevelResult> results;
    for (int limit = 1; limit <= kMost; ++limit) {
      results.push_back(search(objective, cloud, T_init, limit));
      if (results.back().converged) break;
    }
    return results;
  }

  [[nodiscard]] ObjectiveValue value_at(const PointCloud& cloud, double ell, const SE3& T) const {
    Objective objective;
    objective.build(cloud, kernel_, ell);
    return evaluate(objective, cloud, T);
  }

  KernelOptions kernel_;
  StopRule stop_;
};

TEST_F(Newton, EveryStepRaisesTheObjective) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(seed);
    const PointCloud cloud = random_cloud(150, seed);
    const SE3 T_init = motion(0.05, -0.03, 0.04, 0.03, -0.04, 0.05);
    double last = value_at(cloud, 0.1, T_init).value;
    const auto results = steps(cloud, 0.1, T_init);
    for (std::size_t k = 0; k < results.size(); ++k) {
      EXPECT_EQ(results[k].iterations, static_cast<int>(k + 1));
      // The last iteration finds that there is nothing left to gain.
      if (results[k].converged) {
        EXPECT_GE(results[k].value.value, last);
      } else {
        EXPECT_GT(results[k].value.value, last);
      }
      last = results[k].value.value;
    }
    EXPECT_TRUE(results.back().converged);
  }
}

TEST_F(Newton, ConvergesInAFewSteps) {
  // Convergence is quadratic: from 1e-2 by way of 1e-4 to 1e-8, after a step or two.
  const auto results = steps(random_cloud(150, 20), 0.1, motion(0.01, 0, 0.01, 0, 0.01, 0));
  EXPECT_TRUE(results.back().converged);
  EXPECT_LE(results.size(), 6U);
}

TEST_F(Newton, AscendsWhereTheHessianIsIndefinite) {
  // Beyond one length scale from a point its kernel curves upwards; 0.05 m = 1.7 ell is inside the
  // support still. Newton's own step leads away from the maximum there.
  constexpr double kScale = 0.03;
  const PointCloud cloud = random_cloud(30, 21);
  const SE3 T_init = motion(0.05, 0, 0, 0, 0, 0);
  const ObjectiveValue start = value_at(cloud, kScale, T_init);
  const Eigen::MatrixXd hessian = start.hessian;
  ASSERT_LT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(hessian).eigenvalues().minCoeff(), 0);
  const auto results = steps(cloud, kScale, T_init);
  EXPECT_GT(results.front().value.value, start.value);
  EXPECT_LT(results.back().T_fixed_moving.log().norm(), 1e-5) << "and finds the copy";
}

TEST_F(Newton, AStepIsNoLongerThanTheKernelSees) {
  constexpr double kScale = 0.03;
  const PointCloud cloud = random_cloud(150, 22);
  // Rotations move points 1.5 m away by 1.5 m a radian: 0.03 rad is 1.5 ell.
  for (const SE3& T_init : {motion(0.055, 0, 0, 0, 0, 0), motion(0, 0, 0, 0.03, 0, 0),
                            motion(0.03, 0.03, 0, 0, 0, 0.1)}) {
    SE3 last = T_init;
    double longest = 0;
    for (const LevelResult& result : steps(cloud, kScale, T_init)) {
      const Vector6 step = (result.T_fixed_moving * last.inverse()).log();
      constexpr double kRounding = 1 + 1e-9;
      EXPECT_LE(step.head<3>().norm(), kScale * kRounding);
      EXPECT_LE(step.tail<3>().norm(), 0.5 * kScale * kRounding);
      longest = std::max(
          {longest, step.head<3>().norm() / kScale, step.tail<3>().norm() / (0.5 * kScale)});
      last = result.T_fixed_moving;
    }
    EXPECT_GT(longest, 0.2) << "steps were taken";
  }
}

TEST_F(Newton, StaysWhereNothingOverlaps) {
  const SE3 T_init = motion(5, 0, 0, 0, 0, 0);
  const auto results = steps(random_cloud(50, 23), 0.1, T_init);
  EXPECT_EQ(results.front().iterations, 0);
  EXPECT_FALSE(results.front().converged);
  EXPECT_EQ(results.front().value.matched, 0U);
  EXPECT_EQ(results.front().T_fixed_moving.matrix(), T_init.matrix());
}

TEST_F(Newton, StopsWithoutToleranceToo) {
  stop_.translation = stop_.rotation = 0;
  const auto results = steps(random_cloud(150, 24), 0.1, motion(0.02, 0, 0, 0, 0.02, 0));
  EXPECT_TRUE(results.back().converged) << "where no step raises the objective any more";
}

TEST_F(Newton, MayTakeTheLastStepWithoutLooking) {
  stop_.translation = stop_.rotation = 0.02;
  stop_.take_last_step = true;
  const PointCloud cloud = random_cloud(150, 26);
  Objective objective;
  objective.build(cloud, kernel_, 0.1);
  const SE3 T_init = motion(0.01, 0, 0.01, 0, 0.01, 0);
  const LevelResult result = search(objective, cloud, T_init, 20);
  EXPECT_TRUE(result.converged);
  EXPECT_EQ(result.iterations, 1);
  EXPECT_LT(result.T_fixed_moving.log().norm(), 0.2 * T_init.log().norm()) << "it was taken";
}

TEST_F(Newton, DoesNotConvergeWhereThePoseIsFree) {
  // A single point leaves the rotation free: both Hessians are singular.
  const PointCloud point = random_cloud(1, 25);
  Objective objective;
  objective.build(point, kernel_, 0.1);
  const auto result = search(objective, point, motion(0.01, 0, 0, 0, 0, 0), 20);
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(result.iterations, 1);
  EXPECT_TRUE(result.T_fixed_moving.matrix().allFinite());
}

}  // namespace
}  // namespace cvo_slam
