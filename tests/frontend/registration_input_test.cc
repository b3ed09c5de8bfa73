// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Clouds that determine no pose, and options that make no sense.
#include <algorithm>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include <Eigen/Cholesky>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/frontend/registration.h"
#include "cvo_slam/frontend/tracker.h"
#include "cvo_slam/tests/frontend/test_clouds.h"

namespace cvo_slam {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

class RegistrationInput : public testing::TestWithParam<Solver> {
 protected:
  RegistrationInput() {
    options_.solver = GetParam();
    options_.length_scales = {0.1, 0.05};
    options_.max_iterations = {20};
  }

  [[nodiscard]] RegistrationResult run(const PointCloud& fixed, const PointCloud& moving) const {
    return align(fixed, moving, T_init_, options_);
  }

  void expect_failed(const RegistrationResult& result, const std::string& reason) const {
    EXPECT_EQ(result.status, RegistrationStatus::kFailed);
    EXPECT_EQ(result.reason, reason);
    EXPECT_EQ(result.T_fixed_moving.matrix(), T_init_.matrix()) << "the start is given back";
    EXPECT_EQ(result.overlap, 0.0);
    EXPECT_EQ(result.covariance, Matrix6(Matrix6::Zero()));
  }

  static void expect_finite(const RegistrationResult& result) {
    EXPECT_TRUE(result.T_fixed_moving.matrix().allFinite());
    EXPECT_TRUE(result.covariance.allFinite());
    EXPECT_GE(result.overlap, 0);
    EXPECT_LE(result.overlap, 1);
    EXPECT_GE(result.cos_theta, 0);
    EXPECT_LE(result.cos_theta, 1);
    EXPECT_FALSE(result.reason.empty());
  }

  RegistrationOptions options_;
  SE3 T_init_ = motion(0.01, 0.02, -0.01, 0.01, 0, 0.02);
  PointCloud cloud_ = random_cloud(100, 1);
};

TEST_P(RegistrationInput, NoFixedCloud) {
  expect_failed(Registration(options_).align(cloud_, T_init_), "the fixed cloud has no points");
  expect_failed(run(PointCloud(), cloud_), "the fixed cloud has no points");
}

TEST_P(RegistrationInput, FixedCloudWithoutAFinitePoint) {
  PointCloud nowhere = cloud_;
  std::fill(nowhere.x.begin(), nowhere.x.end(), kNan);
  expect_failed(run(nowhere, cloud_), "the fixed cloud has no points");
}

TEST_P(RegistrationInput, EmptyMovingCloud) {
  expect_failed(run(cloud_, PointCloud()), "the moving cloud has no points");
}

TEST_P(RegistrationInput, MovingCloudWithoutAFinitePoint) {
  PointCloud nowhere = cloud_;
  std::fill(nowhere.y.begin(), nowhere.y.end(), kNan);
  expect_failed(run(cloud_, nowhere), "the clouds do not overlap");
}

TEST_P(RegistrationInput, CloudsFarApart) {
  for (const double distance : {3.0, 1e4, 1e30}) {
    expect_failed(run(cloud_, transformed(cloud_, SE3(Matrix3::Identity(), {0, distance, 0}))),
                  "the clouds do not overlap");
  }
}

TEST_P(RegistrationInput, PointsThatAreNotFiniteAreLeftOut) {
  PointCloud holes = cloud_;
  holes.z[3] = kNan;
  holes.x[4] = std::numeric_limits<float>::infinity();
  std::vector<std::size_t> rest;
  for (std::size_t i = 0; i < cloud_.size(); ++i) {
    if (i != 3 && i != 4) rest.push_back(i);
  }
  const auto with = run(cloud_, holes);
  const auto without = run(cloud_, subset(cloud_, rest));
  EXPECT_NE(with.status, RegistrationStatus::kFailed);
  expect_finite(with);
  // Sums run over other chunks, in single precision.
  EXPECT_LT((with.T_fixed_moving.inverse() * without.T_fixed_moving).log().norm(), 1e-6);
  EXPECT_EQ(run(holes, cloud_).status, with.status);
}

TEST_P(RegistrationInput, ShapesThatDoNotDetermineThePose) {
  // The reason once was "iteration limit" after one iteration, with an undetermined pose.
  PointCloud line = cloud_;
  for (auto* axis : {&line.y, &line.z}) std::fill(axis->begin(), axis->end(), 1.0F);
  PointCloud same = line;
  std::fill(same.x.begin(), same.x.end(), 1.0F);
  for (const PointCloud& shape : {subset(cloud_, {0}), subset(cloud_, {0, 1}), line, same}) {
    expect_failed(run(shape, shape),
                  "the points that match do not determine the pose: too few, or all on a line");
  }
}

TEST_P(RegistrationInput, APlaneOfPointsHoldsThePose) {
  PointCloud plane = cloud_;
  std::fill(plane.z.begin(), plane.z.end(), 1.0F);
  const auto result = run(plane, plane);
  EXPECT_NE(result.status, RegistrationStatus::kFailed);
  expect_finite(result);
  EXPECT_EQ(result.overlap, 1.0);
}

TEST_P(RegistrationInput, CovarianceIsPositiveDefiniteAwayFromAMaximumToo) {
  options_.max_iterations = {1};
  for (const double distance : {0.0, 0.02, 0.05, 0.1}) {
    const PointCloud moving = transformed(cloud_, motion(distance, distance, 0, 0, 0, distance));
    const auto result = run(cloud_, moving);
    ASSERT_NE(result.status, RegistrationStatus::kFailed);
    const Eigen::LLT<Eigen::MatrixXd> llt(result.covariance);
    EXPECT_EQ(llt.info(), Eigen::Success) << distance;
  }
}

TEST_P(RegistrationInput, BlackPointsOverlapButHoldNothingUnderTheLinearKernel) {
  options_.kernel.color_kernel = ColorKernel::kLinear;
  PointCloud half_black = cloud_;
  for (std::size_t i = 0; i < cloud_.size(); i += 2) {
    for (std::size_t f = 0; f < 3; ++f) half_black.features[f][i] = 0;
  }
  // Overlap is about neighbours, whatever their colours.
  EXPECT_EQ(run(cloud_, half_black).overlap, 1.0);
}

TEST_P(RegistrationInput, ContradictingOptionsAreRefused) {
  options_.kernel.sparsification = 0.5;
  EXPECT_THROW(std::ignore = run(cloud_, cloud_), OptionError);
}

TEST_P(RegistrationInput, CosThetaStaysInTheUnitIntervalOnALattice) {
  // The kernel that is cut to its support is not positive definite: between the points of a lattice
  // that do not see each other (spacing above 2.15 ell), four neighbours weigh 0.32 each, together
  // more than each point's own weight of one.
  options_.length_scales = {0.045};  // support 0.0966
  options_.max_iterations = {1};
  PointCloud lattice = random_cloud(400, 2);
  for (std::size_t i = 0; i < lattice.size(); ++i) {
    const std::size_t row = i / 20;
    lattice.x[i] = 0.1F * static_cast<float>(i % 20);
    lattice.y[i] = 0.1F * static_cast<float>(row);
    lattice.z[i] = 1;
    for (auto& feature : lattice.features) feature[i] = 100;
  }
  const auto result = align(lattice, lattice, motion(0.05, 0.05, 0, 0, 0, 0), options_);
  ASSERT_NE(result.status, RegistrationStatus::kFailed);
  EXPECT_GT(result.cos_theta, 0.9);
  expect_finite(result);
}

INSTANTIATE_TEST_SUITE_P(Solvers, RegistrationInput,
                         testing::Values(Solver::kFlow, Solver::kNewton));

/// Returns the error message for these options; empty if they are accepted.
std::string error_of(const RegistrationOptions& options) {
  try {
    Registration registration(options);
  } catch (const OptionError& error) {
    return error.what();
  }
  return {};
}

TEST(RegistrationOptions, AreChecked) {
  using ::testing::HasSubstr;
  const auto changed = [](const auto& change) {
    RegistrationOptions options;
    change(options);
    return error_of(options);
  };
  const auto nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(changed([](auto&) {}), "");
  EXPECT_THAT(changed([](auto& o) { o.length_scales.clear(); }), HasSubstr("length_scales"));
  EXPECT_THAT(changed([](auto& o) { o.length_scales = {0.1, 0}; }), HasSubstr("length_scales"));
  EXPECT_THAT(changed([&](auto& o) { o.length_scales = {nan}; }), HasSubstr("length_scales"));
  EXPECT_THAT(changed([](auto& o) { o.max_iterations.clear(); }), HasSubstr("max_iterations"));
  EXPECT_THAT(changed([](auto& o) { o.max_iterations = {0}; }), HasSubstr("max_iterations"));
  EXPECT_THAT(changed([](auto& o) { o.kernel.sigma = -1; }), HasSubstr("kernel.sigma"));
  EXPECT_THAT(changed([](auto& o) { o.tolerance = -1; }), HasSubstr("tolerance"));
  EXPECT_THAT(changed([](auto& o) { o.flow.metric_a2 = 0; }), HasSubstr("flow.metric_a2"));
  EXPECT_THAT(changed([&](auto& o) { o.flow.max_step = nan; }), HasSubstr("flow.max_step"));
}

TEST(PaperOptions, HaveThePapersTable) {
  const TrackerOptions options = paper_options();
  const RegistrationOptions& registration = options.registration;
  EXPECT_EQ(options.reference, Reference::kPreviousFrame);
  EXPECT_EQ(options.prediction, Prediction::kIdentity);
  EXPECT_EQ(options.selection.method, SelectionMethod::kEdges);
  EXPECT_FALSE(options.compensate_depth_delay);
  EXPECT_EQ(registration.solver, Solver::kFlow);
  EXPECT_EQ(registration.kernel.color_kernel, ColorKernel::kLinear);
  EXPECT_EQ(registration.kernel.sigma, 0.1);
  EXPECT_EQ(registration.kernel.sparsification, 1e-3);
  EXPECT_EQ(registration.flow.metric_a2, 7);
  EXPECT_EQ(registration.flow.metric_b2, 7);
  EXPECT_EQ(registration.flow.min_step, 1e-5);
  EXPECT_EQ(registration.flow.min_gradient, 5e-5);
  // ell = 0.15, 0.10 after iteration 3, 0.06 after 10, 0.03 after 20.
  EXPECT_EQ(registration.length_scales, (std::vector<double>{0.15, 0.10, 0.06, 0.03}));
  ASSERT_EQ(registration.max_iterations.size(), 4U);
  EXPECT_EQ(registration.max_iterations[0], 3);
  EXPECT_EQ(registration.max_iterations[1], 10 - 3);
  EXPECT_EQ(registration.max_iterations[2], 20 - 10);
}

}  // namespace
}  // namespace cvo_slam
