// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/core/association.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/tests/core/trajectory_samples.h"

namespace cvo_slam {
namespace {

using testing::ElementsAre;

/// Returns a pose on the x axis at a position that equals its time in seconds.
StampedPose at(std::int64_t ms) {
  return {milliseconds(ms), SE3(Matrix3::Identity(), {static_cast<double>(ms) / 1000, 0, 0})};
}

std::vector<StampedPose> at(std::initializer_list<std::int64_t> times) {
  std::vector<StampedPose> poses;
  for (const auto ms : times) poses.push_back(at(ms));
  return poses;
}

/// Returns the times [ms] of the matched reference poses.
std::vector<long> found(const std::vector<MatchedPose>& matches) {
  std::vector<long> times;
  times.reserve(matches.size());
  for (const auto& match : matches) {
    times.push_back(std::lround(match.reference.translation().x() * 1000));
  }
  return times;
}

std::vector<long> stamps(const std::vector<MatchedPose>& matches) {
  std::vector<long> times;
  times.reserve(matches.size());
  for (const auto& match : matches) times.push_back(match.stamp.nanoseconds() / 1000000);
  return times;
}

TEST(Associate, TakesTheNearestWithinTheBound) {
  const auto matches = associate(at({0, 10, 20, 30, 100}), at({9, 24, 70, 121}));
  EXPECT_THAT(found(matches), ElementsAre(10, 20));
  EXPECT_THAT(stamps(matches), ElementsAre(9, 24));
}

TEST(Associate, TheBoundItselfIsWithin) {
  EXPECT_EQ(associate(at({0}), at({20})).size(), 1U);
  EXPECT_THROW(static_cast<void>(associate(at({0}), at({21}))), DataError);
}

TEST(Associate, OfTwoEquallyNearTheEarlierIsTaken) {
  EXPECT_THAT(found(associate(at({0, 10, 20}), at({5}))), ElementsAre(0));
}

TEST(Associate, TwoPosesMayShareAPartnerAsInEvo) {
  EXPECT_THAT(found(associate(at({0, 10, 100, 110}), at({8, 12, 14}))), ElementsAre(10, 10, 10));
}

TEST(Associate, GoesThroughTheShorterTrajectory) {
  // The reference has fewer poses, so that each of its poses takes one of the estimate.
  const auto matches = associate(at({0, 50}), at({1, 2, 49, 50, 51}));
  EXPECT_THAT(found(matches), ElementsAre(0, 50));
  EXPECT_THAT(stamps(matches), ElementsAre(1, 50));
}

TEST(Associate, TimeOffsetIsAddedToTheEstimate) {
  const auto matches = associate(at({1000, 1100, 1200}), at({0, 100}), {.time_offset = 1.0});
  EXPECT_THAT(found(matches), ElementsAre(1000, 1100));
  EXPECT_THAT(stamps(matches), ElementsAre(1000, 1100));
}

TEST(Associate, InterpolatesInsideTheRangeAndNotOverGaps) {
  const auto matches = associate(at({100, 150, 400, 450}), at({99, 110, 150, 300, 430, 450, 451}),
                                 {.interpolate = true});
  EXPECT_THAT(found(matches), ElementsAre(110, 150, 430, 450));
}

TEST(Associate, SaysWhenNothingCanMatch) {
  EXPECT_THROW(static_cast<void>(associate({}, at({0}))), DataError);
  EXPECT_THROW(static_cast<void>(associate(at({0}), {})), DataError);
  try {
    static_cast<void>(associate(at({0, 100}), at({5000})));
    FAIL();
  } catch (const DataError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("0.000000 to 0.100000 s"));
    EXPECT_THAT(error.what(), testing::HasSubstr("5.000000 to 5.000000 s"));
  }
}

TEST(Associate, RejectsImpossibleOptions) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(static_cast<void>(associate(at({0}), at({0}), {.max_difference = -0.1})),
               OptionError);
  EXPECT_THROW(static_cast<void>(associate(at({0}), at({0}), {.max_difference = nan})),
               OptionError);
  EXPECT_THROW(static_cast<void>(associate(at({0}), at({0}), {.time_offset = nan})), OptionError);
  EXPECT_THROW(static_cast<void>(associate(at({0}), at({0}), {.time_offset = 1e12})), OptionError);
  EXPECT_THROW(static_cast<void>(associate(at({0}), at({0}), {.max_gap = -1})), OptionError);
}

TEST(InterpolateAt, FollowsTheScrewBetweenTwoPoses) {
  // A quarter turn about the vertical axis through (0, 1, 0): half way the camera is on the arc,
  // not on the chord.
  const SE3 start(Matrix3::Identity(), {1, 1, 0});
  const SE3 end(so3_exp({0, 0, std::numbers::pi / 2}), {0, 2, 0});
  const std::vector<StampedPose> poses = {{milliseconds(0), start}, {milliseconds(100), end}};
  const auto middle = interpolate_at(poses, milliseconds(50), 0.1);
  ASSERT_TRUE(middle);
  const double r = std::numbers::sqrt2 / 2;
  EXPECT_LT((middle->translation() - Vector3(r, 1 + r, 0)).norm(), 1e-12);
  EXPECT_NEAR(middle->angle(), std::numbers::pi / 4, 1e-12);
  EXPECT_FALSE(interpolate_at(poses, milliseconds(50), 0.09));
  EXPECT_FALSE(interpolate_at(poses, milliseconds(-1), 1));
  EXPECT_FALSE(interpolate_at(poses, milliseconds(101), 1));
  EXPECT_FALSE(interpolate_at({}, milliseconds(0), 1));
}

}  // namespace
}  // namespace cvo_slam
