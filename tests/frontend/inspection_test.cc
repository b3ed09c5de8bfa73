// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/frontend/inspection.h"

#include <cmath>

#include <gtest/gtest.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/tests/frontend/reference_align.h"
#include "cvo_slam/tests/frontend/test_clouds.h"

namespace cvo_slam {
namespace {

constexpr double kScale = 0.1;

class Inspection : public testing::Test {
 protected:
  KernelOptions kernel_;
  PointCloud fixed_ = random_cloud(300, 1);
  PointCloud moving_ = random_cloud(200, 2);
  SE3 T_ = motion(0.05, -0.03, 0.02, 0.1, -0.05, 0.2);
};

TEST_F(Inspection, TheKernelMatrixHoldsEveryPairInsideTheSupport) {
  std::vector<KernelEntry> expected;
  for (std::uint32_t j = 0; j < moving_.size(); ++j) {
    for (std::uint32_t i = 0; i < fixed_.size(); ++i) {
      const double d2 = (fixed_.position(i) - T_ * moving_.position(j)).squaredNorm();
      const double k = kernel_.sigma * kernel_.sigma * std::exp(-d2 / (2 * kScale * kScale));
      if (k > kernel_.sparsification) expected.push_back({i, j, 0, k});
    }
  }
  ASSERT_GT(expected.size(), 100U);
  const auto entries = kernel_matrix(fixed_, moving_, T_, kernel_, kScale);
  ASSERT_EQ(entries.size(), expected.size());
  for (std::size_t n = 0; n < entries.size(); ++n) {
    EXPECT_EQ(entries[n].fixed, expected[n].fixed);
    EXPECT_EQ(entries[n].moving, expected[n].moving);
    EXPECT_NEAR(entries[n].k, expected[n].k, 1e-15);
    EXPECT_EQ(entries[n].c,
              label_product(kernel_, fixed_, entries[n].fixed, moving_, entries[n].moving));
  }
}

TEST_F(Inspection, PointsThatAreNotFiniteHaveNoEntry) {
  const std::size_t before = kernel_matrix(fixed_, moving_, T_, kernel_, kScale).size();
  fixed_.x[0] = NAN;
  moving_.y[0] = INFINITY;
  const auto entries = kernel_matrix(fixed_, moving_, T_, kernel_, kScale);
  EXPECT_LE(entries.size(), before);
  for (const KernelEntry& entry : entries) {
    EXPECT_NE(entry.fixed, 0U);
    EXPECT_NE(entry.moving, 0U);
  }
}

TEST_F(Inspection, TheSimilarityIsThatOfTheRegistration) {
  const PointCloud moving = transformed(fixed_, T_.inverse());
  RegistrationOptions options;
  options.length_scales = {0.2, kScale};
  const RegistrationResult result = align(fixed_, moving, T_, options);
  ASSERT_NE(result.status, RegistrationStatus::kFailed);
  const CloudSimilarity found =
      similarity(fixed_, moving, result.T_fixed_moving, options.kernel, kScale);
  // The registration sums in single precision.
  EXPECT_NEAR(found.cos_theta, result.cos_theta, 1e-5);
  EXPECT_EQ(found.overlap, result.overlap);
  EXPECT_NEAR(found.inner_product,
              reference_objective(fixed_, moving, result.T_fixed_moving, options.kernel, kScale),
              1e-10 * found.inner_product);
}

TEST_F(Inspection, NothingIsSimilarToNothing) {
  const CloudSimilarity none = similarity(fixed_, {}, T_, kernel_, kScale);
  EXPECT_EQ(none.cos_theta, 0);
  EXPECT_EQ(none.overlap, 0);
  EXPECT_EQ(none.entries, 0U);
  kernel_.sparsification = 1;  // more than the kernel's peak
  EXPECT_TRUE(kernel_matrix(fixed_, moving_, T_, kernel_, kScale).empty());
}

TEST_F(Inspection, TheExactStepCurveIsTheObjective) {
  // With a support wider than the clouds no pair comes or goes.
  kernel_.sparsification = 1e-9;
  constexpr double kWide = 0.5;
  const StepCurve curve(fixed_, moving_, T_, kernel_, {}, kWide);
  ASSERT_TRUE(curve.has_slope());
  EXPECT_EQ(curve.exact(0), 0);
  // The curve rises up to the step of fourth order, and a doubled step overshoots.
  const double step = curve.step();
  EXPECT_GT(curve.exact(step), curve.exact(step / 2));
  EXPECT_GT(curve.exact(step), curve.exact(2 * step));
  const double slope = (curve.exact(1e-6 * step) - curve.exact(-1e-6 * step)) / (2e-6 * step);
  EXPECT_NEAR(slope, curve.coefficients()[0], 1e-5 * slope);  // single precision
}

TEST_F(Inspection, EveryOrderOfTheExpansionIsNearerToTheCurve) {
  const StepCurve curve(fixed_, moving_, T_, kernel_, {}, kScale);
  // Far enough below the step that the series converges, and far enough above 0 that the error of
  // the fourth order exceeds the coefficients' single precision.
  const double t = 0.2 * curve.step();
  double last = std::abs(curve.exact(t));
  for (int order = 1; order <= 4; ++order) {
    const double left = std::abs(curve.exact(t) - curve.expanded(t, order));
    EXPECT_LT(left, 0.5 * last) << order;
    last = left;
  }
  EXPECT_GT(curve.exact(curve.step(4)), 0);
}

TEST_F(Inspection, WithoutPairsTheStepCurveIsZero) {
  const StepCurve curve(fixed_, transformed(moving_, motion(9, 0, 0, 0, 0, 0)), T_, kernel_, {},
                        kScale);
  EXPECT_FALSE(curve.has_slope());
  EXPECT_EQ(curve.exact(1), 0);
  EXPECT_EQ(curve.expanded(1, 4), 0);
  EXPECT_EQ(curve.step(), FlowConstants().fallback_step * kScale * kScale);
}

TEST_F(Inspection, ImpossibleOptionsAreErrors) {
  FlowConstants flow;
  flow.metric_a2 = 0;
  EXPECT_THROW(StepCurve(fixed_, moving_, T_, kernel_, flow, kScale), OptionError);
}

}  // namespace
}  // namespace cvo_slam
