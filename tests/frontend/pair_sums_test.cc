// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The SIMD sums against the same sums in double precision over all pairs.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "cvo_slam/frontend/neighbor_search_internal.h"
#include "cvo_slam/frontend/pair_sums_internal.h"
#include "cvo_slam/tests/frontend/test_clouds.h"

namespace cvo_slam {
namespace {

constexpr double kScale = 0.1;
constexpr std::size_t kSums = sizeof(PairSums) / sizeof(double);
using Array = std::array<double, kSums>;

/// The sums in double precision over all pairs, and the sums of absolute values, by which errors
/// are measured.
struct ExactSums {
  PairSums sum;
  PairSums magnitude;
  double nearest_to_threshold = 1;  ///< smallest |k / sparsification - 1|
};

std::array<double, 9> columns(const Matrix3& m) {
  std::array<double, 9> a{};
  Eigen::Map<Eigen::Matrix3d>(a.data()) = m;
  return a;
}
std::array<double, 6> upper(const Matrix3& m) {
  return {m(0, 0), m(0, 1), m(0, 2), m(1, 1), m(1, 2), m(2, 2)};
}
std::array<double, 3> array(const Vector3& v) { return {v.x(), v.y(), v.z()}; }

void add(const PairSums& part, bool absolute, PairSums& total) {
  auto sum = std::bit_cast<Array>(total);
  const auto addend = std::bit_cast<Array>(part);
  for (std::size_t i = 0; i < kSums; ++i) sum[i] += absolute ? std::abs(addend[i]) : addend[i];
  total = std::bit_cast<PairSums>(sum);
}

/// Returns ell^2 times the precision of the kernel of a moving point, in the frame of the fixed
/// cloud as it was when the neighbours were searched.
Matrix3 precision(const PointCloud& moving, std::size_t j, const SE3& T_searched,
                  const KernelOptions& kernel) {
  Matrix3 covariance = kScale * kScale * Matrix3::Identity();
  if (!moving.surfaces.empty()) {
    const Vector3 n = T_searched.rotation() * moving.surfaces[j].normal.cast<double>();
    const double noise = static_cast<double>(moving.surface_noise) / 1e-3;
    const double roughness = moving.surfaces[j].roughness;
    const double thickness2 = kScale * kScale * (0.01 + noise * noise) + roughness * roughness;
    covariance += (std::min(thickness2, kScale * kScale) - kScale * kScale) * n * n.transpose();
  }
  if (!moving.ray_noise.empty()) {
    const Vector3 d = T_searched.rotation() * moving.position(j).normalized();
    const double noise = kernel.ray_noise * static_cast<double>(moving.ray_noise[j]);
    covariance += noise * noise * d * d.transpose();
  }
  return kScale * kScale * covariance.inverse();
}

ExactSums exact_sums(const PointCloud& fixed, const PointCloud& moving, const SE3& T,
                     const KernelOptions& kernel, const SE3& T_searched) {
  const double inv2 = 1 / (kScale * kScale);
  ExactSums result;
  for (std::size_t j = 0; j < moving.size(); ++j) {
    const Vector3 q = T * moving.position(j);
    const Matrix3 P = precision(moving, j, T_searched, kernel);
    bool matched = false;
    for (std::size_t i = 0; i < fixed.size(); ++i) {
      const Vector3 r = fixed.position(i) - q;
      const Vector3 p = P * r;
      const double k = kernel.sigma * kernel.sigma * std::exp(-r.dot(p) * inv2 / 2);
      result.nearest_to_threshold =
          std::min(result.nearest_to_threshold, std::abs(k / kernel.sparsification - 1));
      if (!(k > kernel.sparsification)) continue;
      matched = true;
      const double c = label_product(kernel, fixed, i, moving, j);
      const double w = c * k;
      const Vector3 s = inv2 * w * p;
      const Matrix3 B = inv2 * w * P;
      const Matrix3 A = B - inv2 * inv2 * w * p * p.transpose();
      const Matrix3 Q = skew(q);
      const PairSums pair{.value = c * (k - kernel.sparsification),
                          .w = w,
                          .matched = 0,
                          .s = array(s),
                          .q_cross_s = array(q.cross(s)),
                          .A = upper(A),
                          .AQ = columns(A * Q),
                          .QAQ = upper(-Q * A * Q),
                          .sq = columns(s * q.transpose()),
                          .B = upper(B),
                          .BQ = columns(B * Q),
                          .QBQ = upper(-Q * B * Q)};
      add(pair, false, result.sum);
      add(pair, true, result.magnitude);
    }
    if (matched) result.sum.matched += 1;
  }
  return result;
}

ExactSums exact_sums(const PointCloud& fixed, const PointCloud& moving, const SE3& T,
                     const KernelOptions& kernel) {
  return exact_sums(fixed, moving, T, kernel, T);
}

/// Single precision knows a position near 2 m to 1.2e-7 m and r to twice that, so at the rim of the
/// support, r = 2.15 ell, the exponent r^2 / (2 ell^2) to 2.15 * 2.4e-7 m / ell = 5e-6; exp, c and
/// the sums add some 1e-7.
constexpr double kRelative = 1e-5;

void expect_near(const PairSums& sums, const ExactSums& exact) {
  ASSERT_GT(exact.nearest_to_threshold, kRelative) << "else rounding decides if a pair counts";
  EXPECT_EQ(sums.matched, exact.sum.matched);
  const auto ours = std::bit_cast<Array>(sums);
  const auto expected = std::bit_cast<Array>(exact.sum);
  const auto magnitude = std::bit_cast<Array>(exact.magnitude);
  for (std::size_t i = 0; i < kSums; ++i) {
    EXPECT_NEAR(ours[i], expected[i], kRelative * magnitude[i]) << "sum " << i;
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

  /// A grid for neighbours up to a quarter further than the support of a length scale.
  [[nodiscard]] NeighborGrid grid(const PointCloud& fixed, double length_scale = kScale) const {
    NeighborGrid result;
    result.build(fixed, 1.25 * support_radius(kernel_, length_scale));
    return result;
  }

  /// A table with neighbours up to a quarter further than the kernel's support.
  [[nodiscard]] PairTable table(const PointCloud& fixed, const PointCloud& moving,
                                const SE3& T) const {
    PairTable pairs;
    pairs.build(grid(fixed), moving, moving.size(), T, kernel_, kScale, Executor());
    return pairs;
  }

  [[nodiscard]] PairSums sums(const PairTable& pairs, const SE3& T) const {
    return sum_pairs(pairs, T, kernel_, kScale, 0, pairs.groups().size());
  }

  KernelOptions kernel_;
  SE3 T_ = motion(0.05, -0.03, 0.02, 0.1, -0.05, 0.2);
};

TEST_P(PairSumsTest, MatchTheSumsOverAllPairs) {
  const PointCloud fixed = random_cloud(900, 1);
  const PointCloud moving = random_cloud(200, 2);
  const PairSums result = sums(table(fixed, moving, T_), T_);
  expect_near(result, exact_sums(fixed, moving, T_, kernel_));
  EXPECT_GT(result.matched, 150);
}

/// A cloud whose points have noise along their rays, from a fifth of the length scale to twice it.
PointCloud noisy_cloud(std::size_t n, unsigned seed) {
  PointCloud cloud = random_cloud(n, seed);
  for (std::size_t j = 0; j < n; ++j) {
    cloud.ray_noise.push_back(
        static_cast<float>(kScale * (0.2 + 0.18 * static_cast<double>(j % 11))));
  }
  return cloud;
}

TEST_P(PairSumsTest, OfKernelsAlongTheRaysMatchTheSumsOverAllPairs) {
  kernel_.ray_noise = 0.8;
  const PointCloud fixed = random_cloud(700, 1);
  const PointCloud moving = noisy_cloud(150, 2);
  const PairTable pairs = table(fixed, moving, T_);
  const PairSums result = sums(pairs, T_);
  expect_near(result, exact_sums(fixed, moving, T_, kernel_));
  EXPECT_GT(result.value, 1.2 * sums(table(fixed, random_cloud(150, 2), T_), T_).value);
  // A pose near by: the rays stay as they were when the neighbours were searched.
  const SE3 near = T_ * motion(0.02, 0, 0.01, 0, 0.01, 0);
  ASSERT_TRUE(pairs.covers(near));
  expect_near(sums(pairs, near), exact_sums(fixed, moving, near, kernel_, T_));
}

/// Gives each point a surface with some normal; every fifth lies on none, some are rough.
void add_surfaces(PointCloud& cloud) {
  cloud.surface_noise = 2e-4F;
  for (std::size_t j = 0; j < cloud.size(); ++j) {
    SurfacePatch patch;
    const auto angle = static_cast<float>(j);
    if (j % 5 != 0) {
      patch.normal =
          Eigen::Vector3f(std::sin(angle), std::cos(3 * angle), std::sin(2 * angle)).normalized();
    }
    patch.roughness = static_cast<float>(kScale * 0.15 * static_cast<double>(j % 9));
    cloud.surfaces.push_back(patch);
  }
}

TEST_P(PairSumsTest, OfKernelsAcrossSurfacesMatchTheSumsOverAllPairs) {
  const PointCloud fixed = random_cloud(900, 1);
  PointCloud moving = random_cloud(200, 2);
  add_surfaces(moving);
  const PairTable pairs = table(fixed, moving, T_);
  const PairSums result = sums(pairs, T_);
  expect_near(result, exact_sums(fixed, moving, T_, kernel_));
  EXPECT_LT(result.value, 0.8 * sums(table(fixed, random_cloud(200, 2), T_), T_).value);
  const SE3 near = T_ * motion(0.02, 0, 0.01, 0, 0.01, 0);
  ASSERT_TRUE(pairs.covers(near));
  expect_near(sums(pairs, near), exact_sums(fixed, moving, near, kernel_, T_));
}

TEST_P(PairSumsTest, OfKernelsWithRayAndSurfaceMatchTheSumsOverAllPairs) {
  kernel_.ray_noise = 0.8;
  const PointCloud fixed = random_cloud(700, 1);
  PointCloud moving = noisy_cloud(150, 2);
  add_surfaces(moving);
  expect_near(sums(table(fixed, moving, T_), T_), exact_sums(fixed, moving, T_, kernel_));
}

TEST_P(PairSumsTest, NoisySurfacesAreOfNoUse) {
  const PointCloud fixed = random_cloud(300, 1);
  PointCloud moving = random_cloud(100, 2);
  add_surfaces(moving);
  moving.surface_noise = 1.2e-3F;  // a Kinect's
  const PairSums with = sums(table(fixed, moving, T_), T_);
  moving.surfaces.clear();
  EXPECT_EQ(std::bit_cast<Array>(with), std::bit_cast<Array>(sums(table(fixed, moving, T_), T_)));
}

TEST_P(PairSumsTest, AreRightForAnyNumberOfPointsAndNeighbours) {
  // Groups and vectors are filled to any remainder.
  for (std::size_t n = 1; n <= 2 * PairTable::kLanes + 1; ++n) {
    SCOPED_TRACE(n);
    PointCloud fixed = random_cloud(n, 3);
    for (auto* axis : {&fixed.x, &fixed.y, &fixed.z}) {
      for (float& value : *axis) value *= 0.01F;  // all in one support
    }
    const PointCloud one = subset(fixed, {0});
    expect_near(sums(table(fixed, one, SE3()), SE3()), exact_sums(fixed, one, SE3(), kernel_));
    // NOLINTNEXTLINE(readability-suspicious-call-argument): the other way round, too
    expect_near(sums(table(one, fixed, SE3()), SE3()), exact_sums(one, fixed, SE3(), kernel_));
  }
}

TEST_P(PairSumsTest, ATableServesEveryPoseThatItCovers) {
  const PointCloud fixed = random_cloud(600, 4);
  const PointCloud moving = random_cloud(150, 5);
  const PairTable pairs = table(fixed, moving, T_);
  EXPECT_TRUE(pairs.covers(T_));
  // The skin is a quarter of 2.15 ell, 54 mm; a turn of 0.01 rad moves points at 2.3 m by 23 mm.
  const SE3 near = T_ * motion(0.02, 0, 0.01, 0, 0.01, 0);
  ASSERT_TRUE(pairs.covers(near));
  expect_near(sums(pairs, near), exact_sums(fixed, moving, near, kernel_));
  EXPECT_FALSE(pairs.covers(T_ * motion(0.06, 0, 0, 0, 0, 0)));
  EXPECT_FALSE(pairs.covers(T_ * motion(0, 0, 0, 0, 0.06, 0)));
}

TEST_P(PairSumsTest, APointWithoutNeighboursCountsForWhatATableCovers) {
  const PointCloud fixed = random_cloud(600, 4);
  PointCloud moving = random_cloud(150, 5);
  const SE3 turn = motion(0, 0, 0, 0, 0.01, 0);
  ASSERT_TRUE(table(fixed, moving, SE3()).covers(turn));
  moving.z[0] = 10;  // moves by 100 mm; the skin is 54 mm
  EXPECT_FALSE(table(fixed, moving, SE3()).covers(turn));
  PairTable pairs = table(fixed, moving, SE3());
  moving.x[0] += 1;
  ASSERT_TRUE(pairs.reuse(grid(fixed), moving, moving.size(), kernel_, kScale));
  EXPECT_FALSE(pairs.covers(SE3()));
}

TEST_P(PairSumsTest, ATableServesAnotherKernelOfTheSameClouds) {
  const PointCloud fixed = random_cloud(600, 4);
  PointCloud moving = random_cloud(150, 5);
  PairTable pairs;
  pairs.build(grid(fixed, 1.2 * kScale), moving, moving.size(), T_, kernel_, 1.2 * kScale,
              Executor());
  for (float& x : moving.x) x += 0.01F;
  add_surfaces(moving);
  ASSERT_TRUE(pairs.reuse(grid(fixed), moving, moving.size(), kernel_, kScale));
  ASSERT_TRUE(pairs.covers(T_));
  expect_near(sums(pairs, T_), exact_sums(fixed, moving, T_, kernel_));
  // The skin is 1.25 * 1.2 - 1 = 0.5 of the support, 107 mm; the points have used up 10 mm.
  EXPECT_TRUE(pairs.covers(T_ * motion(0.09, 0, 0, 0, 0, 0)));
  EXPECT_FALSE(pairs.covers(T_ * motion(0.10, 0, 0, 0, 0, 0)));
}

TEST_P(PairSumsTest, ATableDoesNotServeOtherCloudsOrWiderKernels) {
  const PointCloud fixed = random_cloud(600, 4);
  const PointCloud moving = random_cloud(150, 5);
  const NeighborGrid same = grid(fixed);
  PairTable pairs;
  EXPECT_FALSE(pairs.reuse(same, moving, moving.size(), kernel_, kScale)) << "nothing was built";
  pairs.build(same, moving, moving.size(), T_, kernel_, kScale, Executor());
  EXPECT_TRUE(pairs.reuse(same, moving, moving.size(), kernel_, kScale));
  EXPECT_FALSE(pairs.reuse(same, moving, 100, kernel_, kScale));
  EXPECT_FALSE(pairs.reuse(same, moving, moving.size(), kernel_, 1.3 * kScale));
  EXPECT_FALSE(
      pairs.reuse(grid(fixed, 0.5 * kScale), moving, moving.size(), kernel_, 0.5 * kScale));
  pairs.clear();
  EXPECT_FALSE(pairs.reuse(same, moving, moving.size(), kernel_, kScale));
}

TEST_P(PairSumsTest, OfTheFirstPointsAlone) {
  const PointCloud fixed = random_cloud(300, 4);
  const PointCloud moving = random_cloud(40, 5);
  PairTable pairs;
  pairs.build(grid(fixed), moving, 11, T_, kernel_, kScale, Executor());
  const PointCloud part = subset(moving, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10});
  expect_near(sums(pairs, T_), exact_sums(fixed, part, T_, kernel_));
}

TEST_P(PairSumsTest, APointWithoutNeighboursOrWithoutPlaceGivesNothing) {
  PointCloud moving = random_cloud(3, 6);
  moving.x[0] = 50;
  moving.y[1] = std::numeric_limits<float>::quiet_NaN();
  moving.z[2] = std::numeric_limits<float>::infinity();
  const PairTable pairs = table(random_cloud(300, 7), moving, SE3());
  EXPECT_TRUE(pairs.groups().empty());
  EXPECT_EQ(std::bit_cast<Array>(sums(pairs, SE3())), Array());
}

TEST_P(PairSumsTest, InnerProductsAreThoseOfAllPairs) {
  const PointCloud cloud = random_cloud(400, 8);
  NeighborGrid grid;
  grid.build(cloud, support_radius(kernel_, kScale));
  const ExactSums exact = exact_sums(cloud, cloud, SE3(), kernel_);
  ASSERT_GT(exact.nearest_to_threshold, kRelative);
  EXPECT_NEAR(sum_inner_products(grid, cloud, kernel_, kScale, 0, cloud.size()), exact.sum.w,
              kRelative * exact.sum.w);
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
