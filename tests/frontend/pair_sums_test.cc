// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The SIMD sums against the same sums in double precision over all pairs.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cvo_slam/frontend/pair_sums_internal.h"
#include "cvo_slam/tests/frontend/test_clouds.h"

namespace cvo_slam {
namespace {

constexpr double kScale = 0.1;

struct ExactSums {
  double w = 0;
  double excess = 0;
  Vector3 r = Vector3::Zero();
  Matrix3 rr = Matrix3::Zero();
  double nearest_to_threshold = 1;  ///< smallest |k / sparsification - 1|
};

ExactSums exact_sums(const PointCloud& fixed, const PointCloud& moving, std::size_t j, const SE3& T,
                     const KernelOptions& kernel) {
  ExactSums sums;
  for (std::size_t i = 0; i < fixed.size(); ++i) {
    const Vector3 r = fixed.position(i) - T * moving.position(j);
    const double k =
        kernel.sigma * kernel.sigma * std::exp(-r.squaredNorm() / (2 * kScale * kScale));
    sums.nearest_to_threshold =
        std::min(sums.nearest_to_threshold, std::abs(k / kernel.sparsification - 1));
    if (k <= kernel.sparsification) continue;
    const double c = label_product(kernel, fixed, i, moving, j);
    sums.w += c * k;
    sums.excess += c * (k - kernel.sparsification);
    sums.r += c * k * r;
    sums.rr += c * k * r * r.transpose();
  }
  return sums;
}

/// Single precision knows a position near 2 m to 1.2e-7 m and r to twice that, so at the rim of the
/// support, r = 2.15 ell, the exponent r^2 / (2 ell^2) to 2.15 * 2.4e-7 m / ell = 5e-6; exp, c and
/// the sums add some 1e-7.
constexpr double kRelative = 1e-5;

void expect_near(const PairSums& sums, const ExactSums& exact) {
  constexpr double kReach = 2.15 * kScale;  // of r
  const double tolerance = kRelative * exact.w;
  EXPECT_NEAR(sums.w, exact.w, tolerance);
  EXPECT_NEAR(sums.excess, exact.excess, tolerance);
  for (int a = 0; a < 3; ++a) EXPECT_NEAR(sums.r[a], exact.r[a], kReach * tolerance) << a;
  constexpr std::array<std::array<int, 2>, 6> kPlaces{
      {{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}}};
  for (std::size_t k = 0; k < kPlaces.size(); ++k) {
    EXPECT_NEAR(sums.rr[k], exact.rr(kPlaces[k][0], kPlaces[k][1]), kReach * kReach * tolerance)
        << k;
  }
}

class PairSumsTest : public testing::TestWithParam<ColorKernel> {
 protected:
  PairSumsTest() {
    kernel_.sigma = 0.1;
    kernel_.sparsification = 1e-3;
    kernel_.color_kernel = GetParam();
    kernel_.color_scale = 80;
    kernel_.gradient_scale = 50;
  }

  [[nodiscard]] std::vector<PairSums> sums(const PointCloud& fixed, const PointCloud& moving,
                                           const SE3& T) const {
    NeighborGrid grid;
    grid.build(fixed, support_radius(kernel_, kScale));
    std::vector<PairSums> sums(moving.size());
    sum_pairs(grid, moving, T, kernel_, kScale, 0, moving.size(), sums.data());
    return sums;
  }

  KernelOptions kernel_;
  SE3 T_ = motion(0.05, -0.03, 0.02, 0.1, -0.05, 0.2);
};

TEST_P(PairSumsTest, MatchTheSumsOverAllPairs) {
  const PointCloud fixed = random_cloud(900, 1);
  const PointCloud moving = random_cloud(200, 2);
  const auto result = sums(fixed, moving, T_);
  int with_pairs = 0;
  for (std::size_t j = 0; j < moving.size(); ++j) {
    const ExactSums exact = exact_sums(fixed, moving, j, T_, kernel_);
    // Otherwise rounding decides whether a pair counts.
    if (exact.nearest_to_threshold < kRelative) continue;
    SCOPED_TRACE(j);
    expect_near(result[j], exact);
    with_pairs += exact.w > 0 ? 1 : 0;
  }
  EXPECT_GT(with_pairs, 150);
}

TEST_P(PairSumsTest, LanesBeyondARunDoNotCount) {
  // Runs shorter and longer than a vector by any remainder, with the padding behind the last one.
  for (std::size_t n = 1; n <= 2 * NeighborGrid::kPadding + 1; ++n) {
    PointCloud fixed = random_cloud(n, 3);
    for (auto* axis : {&fixed.x, &fixed.y, &fixed.z}) {
      for (float& value : *axis) value *= 0.01F;  // where the padding is, all in one support
    }
    const PointCloud moving = subset(fixed, {0});
    SCOPED_TRACE(n);
    expect_near(sums(fixed, moving, SE3()).front(), exact_sums(fixed, moving, 0, SE3(), kernel_));
  }
}

TEST_P(PairSumsTest, APartOfTheCloudGivesThoseOfThePart) {
  const PointCloud fixed = random_cloud(300, 4);
  const PointCloud moving = random_cloud(40, 5);
  const auto all = sums(fixed, moving, T_);
  NeighborGrid grid;
  grid.build(fixed, support_radius(kernel_, kScale));
  std::array<PairSums, 7> part;
  sum_pairs(grid, moving, T_, kernel_, kScale, 11, 18, part.data());
  for (std::size_t k = 0; k < part.size(); ++k) {
    EXPECT_EQ(part[k].w, all[11 + k].w);
    EXPECT_EQ(part[k].rr[5], all[11 + k].rr[5]);
  }
}

TEST_P(PairSumsTest, APointWithoutNeighboursOrWithoutPlaceGivesZero) {
  PointCloud moving = random_cloud(3, 6);
  moving.x[0] = 50;
  moving.y[1] = std::numeric_limits<float>::quiet_NaN();
  moving.z[2] = std::numeric_limits<float>::infinity();
  // Results are written, not added to.
  std::vector<PairSums> result(3);
  for (auto& sum : result) sum.w = 7;
  NeighborGrid grid;
  grid.build(random_cloud(300, 7), support_radius(kernel_, kScale));
  sum_pairs(grid, moving, SE3(), kernel_, kScale, 0, 3, result.data());
  for (const auto& sum : result) {
    EXPECT_EQ(sum.w, 0);
    EXPECT_EQ(sum.excess, 0);
    for (const float r : sum.r) EXPECT_EQ(r, 0);
    for (const float rr : sum.rr) EXPECT_EQ(rr, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(ColorKernels, PairSumsTest,
                         testing::Values(ColorKernel::kLinear, ColorKernel::kSquaredExponential));

TEST(SimdExp, HasARelativeErrorBelow3e7) {
  // Taylor's polynomial of degree 6 at |r| = ln(2) / 2 leaves r^7 / 5040 = 1.2e-7 of 1, which is
  // 1.7e-7 of e^-|r|; rounding adds up to one unit in the last place, 1.2e-7.
  std::vector<float> x;
  constexpr int kSteps = 1'000'000;
  for (int i = 0; i <= kSteps; ++i) x.push_back(-80.0F * static_cast<float>(i) / kSteps);
  const auto y = simd_exp(x);
  ASSERT_EQ(y.size(), x.size());
  double worst = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double exact = std::exp(static_cast<double>(x[i]));
    worst = std::max(worst, std::abs(y[i] - exact) / exact);
  }
  RecordProperty("worst", std::to_string(worst * 1e9) + "e-9");
  EXPECT_LT(worst, 3e-7);
}

TEST(SimdExp, OfZeroIsOne) {
  EXPECT_EQ(simd_exp(std::vector<float>{0.0F, -0.0F}), std::vector<float>({1.0F, 1.0F}));
}

TEST(SimdExp, StaysAtItsSmallestValueBelowMinus80) {
  const auto y = simd_exp(
      std::vector<float>{-80.0F, -80.1F, -1e3F, -1e30F, -std::numeric_limits<float>::infinity()});
  for (const float value : y) EXPECT_EQ(value, y.front());
  EXPECT_GT(y.front(), 0.0F);
  EXPECT_LT(y.front(), 2e-35F);
}

}  // namespace
}  // namespace cvo_slam
