// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/loop/pose_search_internal.h"
#include "cvo_slam/tests/loop/point_pairs.h"

namespace cvo_slam {
namespace {

const SE3 kTruth = SE3::exp((Vector6() << 0.2, -0.1, 0.15, 0.1, -0.25, 0.3).finished());
const Camera kCamera;
constexpr double kMaxReprojection = 3;  // [px]

/// Which features of the pairs have a depth.
enum class Depths { kBoth, kOnlyA, kOnlyB, kMixed };

std::vector<PointPair> make_pairs(int inliers, int outliers, Depths depths, unsigned seed) {
  PairSource source(kCamera, kTruth, seed);
  std::vector<PointPair> pairs;
  pairs.reserve(static_cast<std::size_t>(inliers + outliers));
  for (int i = 0; i < inliers; ++i) pairs.push_back(source.inlier(0.7, 0.002));
  for (int i = 0; i < outliers; ++i) pairs.push_back(source.outlier());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const bool even = i % 2 == 0;
    if (depths == Depths::kOnlyA || (depths == Depths::kMixed && even)) pairs[i].b.depth = 0;
    if (depths == Depths::kOnlyB || (depths == Depths::kMixed && !even)) pairs[i].a.depth = 0;
  }
  return pairs;
}

class PoseSearch : public testing::TestWithParam<Depths> {};

TEST_P(PoseSearch, FindsThePoseAmongAsManyOutliers) {
  const PairModel model(kCamera, kMaxReprojection);
  for (unsigned seed = 0; seed < 10; ++seed) {
    const auto pairs = make_pairs(60, 60, GetParam(), seed);
    const auto pose = search_pose(pairs, model, 500, Random({seed}));
    ASSERT_TRUE(pose);
    // 60 points at 1 to 3 m with 0.7 px: a millimetre or two; five times that here.
    EXPECT_LT((pose->inverse() * kTruth).translation().norm(), 0.01) << seed;
    EXPECT_LT((pose->inverse() * kTruth).angle(), 0.005) << seed;
    EXPECT_GE(inliers_of(*pose, pairs, model).size(), 55U);
  }
}

INSTANTIATE_TEST_SUITE_P(Depths, PoseSearch,
                         testing::Values(Depths::kBoth, Depths::kOnlyA, Depths::kOnlyB,
                                         Depths::kMixed));

TEST(PoseSearchInput, TheSameSeedGivesTheSamePose) {
  const PairModel model(kCamera, kMaxReprojection);
  const auto pairs = make_pairs(30, 30, Depths::kBoth, 3);
  const auto first = search_pose(pairs, model, 200, Random({7}));
  const auto second = search_pose(pairs, model, 200, Random({7}));
  EXPECT_EQ(first->matrix(), second->matrix());
}

TEST(PoseSearchInput, TooFewOrDegeneratePairsGiveNone) {
  const PairModel model(kCamera, kMaxReprojection);
  EXPECT_FALSE(search_pose({}, model, 100, Random({1})));
  EXPECT_FALSE(search_pose(make_pairs(2, 0, Depths::kBoth, 1), model, 100, Random({1})));
  // The same pair many times.
  const std::vector<PointPair> same(20, make_pairs(1, 0, Depths::kBoth, 1)[0]);
  EXPECT_FALSE(search_pose(same, model, 100, Random({1})));
}

TEST(PairModel, ErrorIsOneAtItsLimits) {
  const PairModel model(kCamera, kMaxReprojection);
  PairSource source(kCamera, SE3(), 1);
  PointPair pair = source.inlier(0, 0);
  EXPECT_NEAR(model.error(SE3(), SE3(), pair), 0, 1e-6);
  PointPair moved = pair;
  moved.b.x += static_cast<float>(kMaxReprojection / kCamera.color.fx);
  EXPECT_NEAR(model.error(SE3(), SE3(), moved), 1, 1e-3);
  // The position of a corner of a coarse level is less certain.
  moved.a.size = moved.b.size = 2;
  EXPECT_NEAR(model.error(SE3(), SE3(), moved), 0.25, 1e-3);
  PointPair farther = pair;
  farther.b.depth += static_cast<float>(3 * std::sqrt(2) * model.depth_deviation(pair.b.depth));
  EXPECT_NEAR(model.error(SE3(), SE3(), farther), 1, 0.05);
  const SE3 behind(Matrix3::Identity(), {0, 0, -10});
  EXPECT_GT(model.error(behind, behind.inverse(), pair), 1);
}

/// The information is that of the errors: their squared Mahalanobis norm (NEES) averages to 6.
TEST(PairModel, InformationIsThatOfTheErrors) {
  const PairModel model(kCamera, kMaxReprojection);
  double sum = 0;
  constexpr int kTrials = 100;
  for (unsigned trial = 0; trial < kTrials; ++trial) {
    PairSource source(kCamera, kTruth, 100 + trial);
    std::vector<PointPair> pairs;
    pairs.reserve(80);
    for (int i = 0; i < 80; ++i)
      pairs.push_back(source.inlier(kCamera.noise.pixel, kCamera.noise.depth_floor));
    const PoseEstimate estimate = model.refine(kTruth, pairs);
    const Vector6 error = (kTruth.inverse() * estimate.T_a_b).log();
    sum += error.dot(estimate.information * error);
  }
  // Each residual contains the noise of both pixels, and that of depth across the line of sight,
  // which the model does not include: its information is about twice too large.
  const double nees = sum / kTrials / 6;
  EXPECT_GT(nees, 0.5);
  EXPECT_LT(nees, 3);
  RecordProperty("nees", std::to_string(nees));
}

}  // namespace
}  // namespace cvo_slam
