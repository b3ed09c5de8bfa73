// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "cvo_slam/slam/part_links_internal.h"

namespace cvo_slam {
namespace {

SE3 at(double x, double y, double yaw = 0) {
  Vector6 turn = Vector6::Zero();
  turn[5] = yaw;
  return SE3(Matrix3::Identity(), {x, y, 0}) * SE3::exp(turn);
}

/// Two parts of five keyframes each, half a metre apart; the world of the second one is elsewhere.
class PartLinks : public testing::Test {
 protected:
  PartLinks() {
    for (std::size_t i = 0; i < 2 * kKeyframes; ++i) {
      KeyframeView view;
      view.T_world_camera = at(0.5 * static_cast<double>(i % kKeyframes), 0);
      views_.push_back(view);
    }
  }

  /// A link by which the second part's keyframe stands where the first part's does, but for an
  /// error.
  void link(std::size_t keyframe, const SE3& error = {}) {
    const SE3 T_older_newer =
        views_[0].T_world_camera.inverse() * T_worlds_ * error * newer(keyframe).T_world_camera;
    links_.push_back({0, kKeyframes + keyframe, {T_older_newer, Matrix6::Identity()}, 0});
  }
  [[nodiscard]] const KeyframeView& newer(std::size_t i) const { return views_[kKeyframes + i]; }
  [[nodiscard]] PartPlacement place() const { return place_part(links_, views_, options_); }

  static constexpr std::size_t kKeyframes = 5;
  SE3 T_worlds_ = at(3, -2, 1.2);
  std::vector<KeyframeView> views_;
  std::vector<PartLink> links_;
  RelocalizationOptions options_;
};

TEST_F(PartLinks, OfSeveralKeyframesThatAgreeAreCertain) {
  link(0);
  link(1);
  EXPECT_FALSE(place().is_certain(options_));
  link(2);
  const PartPlacement placement = place();
  EXPECT_TRUE(placement.is_certain(options_));
  EXPECT_EQ(placement.agreeing, (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_LT((placement.T_world_world.inverse() * T_worlds_).log().norm(), 1e-12);
}

TEST_F(PartLinks, OfOneKeyframeAreNot) {
  for (int i = 0; i < 5; ++i) link(0);
  EXPECT_EQ(place().keyframes, 1U);
  EXPECT_FALSE(place().is_certain(options_));
}

TEST_F(PartLinks, OneThatIsWrongIsLeftOut) {
  link(0);
  link(1);
  link(2, at(6, 0));
  link(3);
  const PartPlacement placement = place();
  EXPECT_TRUE(placement.is_certain(options_));
  EXPECT_EQ(placement.agreeing, (std::vector<std::size_t>{0, 1, 3}));
  EXPECT_EQ(placement.rivals, 1U);
}

TEST_F(PartLinks, ARivalPlaceLeavesItOpen) {
  for (const std::size_t i : {0U, 1U, 2U}) link(i);
  for (const std::size_t i : {3U, 4U}) link(i, at(6, 0));
  EXPECT_EQ(place().keyframes, 3U);
  EXPECT_EQ(place().rivals, 2U);
  EXPECT_FALSE(place().is_certain(options_));
}

TEST_F(PartLinks, OfNothingAreNot) { EXPECT_FALSE(place().is_certain(options_)); }

}  // namespace
}  // namespace cvo_slam
