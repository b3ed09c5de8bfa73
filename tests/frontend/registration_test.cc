// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Both solvers find known motions, agree with the oracle, and describe their result correctly.
#include "cvo_slam/frontend/registration.h"

#include <cmath>
#include <random>
#include <tuple>
#include <utility>
#include <vector>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "cvo_slam/tests/frontend/reference_align.h"
#include "cvo_slam/tests/frontend/solver_checks.h"
#include "cvo_slam/tests/frontend/test_clouds.h"

namespace cvo_slam {
namespace {

class Solvers : public testing::TestWithParam<std::tuple<Solver, ColorKernel>> {
 protected:
  [[nodiscard]] static RegistrationOptions options(std::vector<double> length_scales) {
    return exact_options(std::get<0>(GetParam()), std::get<1>(GetParam()),
                         std::move(length_scales));
  }
};

TEST_P(Solvers, FindAKnownMotion) {
  // The true pose of a moved copy is stationary, because its pairs cancel two by two: the error is
  // the solver's tolerance and the single precision of positions near 1 m.
  for (unsigned seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(seed);
    const PointCloud fixed = centred_cloud(150, seed);
    const SE3 T = random_motion(0.04, 0.06, 100 + seed);
    const auto result =
        align(fixed, transformed(fixed, T.inverse()), SE3(), options({0.1, 0.05, 0.025, 0.015}));
    EXPECT_EQ(result.status, RegistrationStatus::kConverged);
    EXPECT_EQ(result.reason, "converged");
    expect_near(result.T_fixed_moving, T, 5e-6, 5e-6);
  }
}

TEST_P(Solvers, EndWhereTheOracleStandsStill) {
  constexpr double kScale = 0.1;
  const RegistrationOptions options = Solvers::options({kScale});
  for (unsigned seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    const PointCloud fixed = centred_cloud(100, seed);
    const SE3 T = random_motion(0.01, 0.02, 200 + seed);
    const PointCloud moving = noisy(transformed(fixed, T.inverse()), 300 + seed);
    const SE3 found = align(fixed, moving, SE3(), options).T_fixed_moving;
    expect_agreement(reference_align(fixed, moving, found, options.kernel, kScale), found);
  }
}

TEST_P(Solvers, SayThatEqualCloudsAreEqual) {
  const PointCloud cloud = centred_cloud(150, 1);
  const auto result = align(cloud, cloud, SE3(), options({0.1, 0.03}));
  EXPECT_EQ(result.status, RegistrationStatus::kConverged);
  EXPECT_EQ(result.overlap, 1.0);
  EXPECT_NEAR(result.cos_theta, 1.0, 1e-6);  // single precision
  expect_near(result.T_fixed_moving, SE3(), 1e-7, 1e-7);
}

TEST_P(Solvers, CountPointsWithoutAPartnerInTheOverlap) {
  const PointCloud fixed = centred_cloud(100, 2);
  PointCloud moving = fixed;
  for (std::size_t i = 0; i < 30; ++i) moving.x[i] += 10;
  const auto result = align(fixed, moving, SE3(), options({0.05}));
  EXPECT_NEAR(result.overlap, 0.7, 1e-12);
  EXPECT_GT(result.cos_theta, 0.5);
  EXPECT_LT(result.cos_theta, 0.8);  // 0.7, and some chance neighbours
}

TEST_P(Solvers, StopAtTheIterationLimit) {
  RegistrationOptions options = Solvers::options({0.1, 0.05, 0.03});
  options.max_iterations = {1};  // it holds for the scales after the first too
  const PointCloud fixed = centred_cloud(150, 3);
  const SE3 T = random_motion(0.04, 0.06, 4);
  const auto result = align(fixed, transformed(fixed, T.inverse()), SE3(), options);
  EXPECT_EQ(result.status, RegistrationStatus::kIterationLimit);
  EXPECT_EQ(result.reason, "iteration limit");
  EXPECT_EQ(result.iterations, 3);
}

INSTANTIATE_TEST_SUITE_P(All, Solvers,
                         testing::Combine(testing::Values(Solver::kFlow, Solver::kNewton),
                                          testing::Values(ColorKernel::kLinear,
                                                          ColorKernel::kSquaredExponential)));

TEST(Registration, InformationIsTheScaledHessianOfARightPerturbation) {
  constexpr double kScale = 0.3;
  RegistrationOptions options =
      exact_options(Solver::kNewton, ColorKernel::kSquaredExponential, {kScale});
  options.kernel.sparsification = 1e-9;  // smooth, as differentiation needs
  const PointCloud fixed = random_cloud(60, 5);
  const SE3 T = random_motion(0.1, 0.2, 6);  // away from the identity, where left and right differ
  const PointCloud moving = noisy(transformed(fixed, T.inverse()), 7);
  const auto result = align(fixed, moving, T, options);
  ASSERT_EQ(result.status, RegistrationStatus::kConverged);
  ASSERT_EQ(result.overlap, 1.0);

  const auto f = [&](const Vector6& xi) {
    return reference_objective(fixed, moving, result.T_fixed_moving * SE3::exp(xi), options.kernel,
                               kScale);
  };
  // Each moving point is one measurement: the mean of their sums of weights counts 1 / ell^2.
  const double mean_weight = f(Vector6::Zero()) / static_cast<double>(moving.size());
  constexpr double kStep = 1e-4;
  Matrix6 numeric;
  for (int a = 0; a < 6; ++a) {
    for (int b = 0; b < 6; ++b) {
      const Vector6 da = kStep * Vector6::Unit(a);
      const Vector6 db = kStep * Vector6::Unit(b);
      numeric(a, b) =
          -(f(da + db) - f(da - db) - f(db - da) + f(-da - db)) / (4 * kStep * kStep * mean_weight);
    }
  }
  EXPECT_LT((inverse_of_spd(result.covariance) - numeric).norm(), 1e-4 * numeric.norm());
}

TEST(Registration, InformationOfEqualCloudsIsSymmetricAndPositiveDefinite) {
  const PointCloud cloud = random_cloud(200, 8);
  const auto result =
      align(cloud, cloud, SE3(),
            exact_options(Solver::kNewton, ColorKernel::kSquaredExponential, {0.02}));
  const Matrix6 information = inverse_of_spd(result.covariance);
  EXPECT_LT((information - information.transpose()).norm(), 1e-9 * information.norm());
  const Eigen::MatrixXd matrix = information;
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvalues().minCoeff(), 0);
  // With hardly any neighbour beside the own one, 200 measurements of 2 cm in each axis.
  const double expected = 200 / (0.02 * 0.02);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(information(k, k), expected, 0.1 * expected);
}

TEST(Registration, IsTheSameToTheBitForAnyNumberOfThreads) {
  const PointCloud fixed = random_cloud(1500, 9);
  const SE3 T = random_motion(0.03, 0.03, 10);
  const PointCloud moving = noisy(transformed(fixed, T.inverse()), 11);
  for (const Solver solver : {Solver::kNewton, Solver::kFlow}) {
    RegistrationOptions options =
        exact_options(solver, ColorKernel::kSquaredExponential, {0.05, 0.03});
    options.max_iterations = {8};
    const auto run = [&](int threads) {
      Registration registration(options, threads);
      registration.set_fixed(fixed);
      return registration.align(moving, SE3());
    };
    const auto one = run(1);
    for (const int threads : {2, 8}) {
      const auto many = run(threads);
      EXPECT_EQ(one.T_fixed_moving.matrix(), many.T_fixed_moving.matrix());
      EXPECT_EQ(one.covariance, many.covariance);
      EXPECT_EQ(one.objective, many.objective);
      EXPECT_EQ(one.cos_theta, many.cos_theta);
      EXPECT_EQ(one.iterations, many.iterations);
    }
  }
}

TEST(Registration, ServesManyMovingCloudsAndForgetsTheLastFixedOne) {
  const auto options =
      exact_options(Solver::kNewton, ColorKernel::kSquaredExponential, {0.1, 0.03});
  Registration registration(options);
  for (unsigned seed = 20; seed < 23; ++seed) {
    const PointCloud fixed = centred_cloud(150, seed);
    registration.set_fixed(fixed);
    for (unsigned k = 0; k < 2; ++k) {
      const PointCloud moving =
          transformed(fixed, random_motion(0.03, 0.03, 10 * seed + k).inverse());
      const auto reused = registration.align(moving, SE3());
      const auto fresh = align(fixed, moving, SE3(), options);
      EXPECT_EQ(reused.T_fixed_moving.matrix(), fresh.T_fixed_moving.matrix());
      EXPECT_EQ(reused.covariance, fresh.covariance);
    }
  }
}

}  // namespace
}  // namespace cvo_slam
