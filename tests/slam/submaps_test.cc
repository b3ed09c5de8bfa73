// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstddef>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "cvo_slam/slam/map_state_internal.h"
#include "cvo_slam/slam/submaps_internal.h"

namespace cvo_slam {
namespace {

SE3 at(double x, double y, double yaw = 0) {
  Vector6 turn = Vector6::Zero();
  turn[5] = yaw;
  return SE3(Matrix3::Identity(), {x, y, 0}) * SE3::exp(turn);
}

/// Two submaps of five keyframes each, half a metre apart; the world of the second one is
/// elsewhere.
class SubmapLinks : public testing::Test {
 protected:
  SubmapLinks() {
    for (std::size_t i = 0; i < 2 * kKeyframes; ++i) {
      map_.keyframes.add({10 * i, Timestamp(), i < kKeyframes ? 0 : 1, CompactCloud(), 0});
      map_.graph.add_keyframe(10 * i, at(0.5 * static_cast<double>(i % kKeyframes), 0));
    }
  }

  /// Adds a link by which the second submap's keyframe stands where the first submap's does, but
  /// for an error.
  void link(std::size_t keyframe, const SE3& error = {}) {
    const SE3 T_older_newer =
        map_.graph.pose(0).inverse() * T_worlds_ * error * map_.graph.pose(kKeyframes + keyframe);
    links_.push_back(
        {0, 10 * (kKeyframes + keyframe), {T_older_newer, Matrix6::Identity()}, links_.size()});
  }
  [[nodiscard]] SubmapPlacement place() const { return place_submap(links_, map_, options_); }
  static std::vector<std::size_t> rows(const std::vector<SubmapLink>& links) {
    std::vector<std::size_t> rows;
    rows.reserve(links.size());
    for (const SubmapLink& link : links) rows.push_back(link.row);
    return rows;
  }
  void add_edge(EdgeKind kind, std::size_t older, std::size_t newer) {
    map_.graph.add_edge(kind, older, newer, {}, {});
    map_.submaps = submaps_of(map_);
  }

  static constexpr std::size_t kKeyframes = 5;
  SE3 T_worlds_ = at(3, -2, 1.2);
  MapState map_{OptimizerOptions()};
  std::vector<SubmapLink> links_;
  RelocalizationOptions options_;
};

TEST_F(SubmapLinks, OfSeveralKeyframesThatAgreeAreCertain) {
  link(0);
  link(1);
  EXPECT_FALSE(place().is_certain(options_));
  link(2);
  const SubmapPlacement placement = place();
  EXPECT_TRUE(placement.is_certain(options_));
  EXPECT_EQ(rows(placement.agreeing), (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_LT((placement.T_world_world.inverse() * T_worlds_).log().norm(), 1e-12);
}

TEST_F(SubmapLinks, OfOneKeyframeAreNot) {
  for (int i = 0; i < 5; ++i) link(0);
  EXPECT_EQ(place().keyframes, 1U);
  EXPECT_FALSE(place().is_certain(options_));
}

TEST_F(SubmapLinks, OneThatIsWrongIsLeftOut) {
  link(0);
  link(1);
  link(2, at(6, 0));
  link(3);
  const SubmapPlacement placement = place();
  EXPECT_TRUE(placement.is_certain(options_));
  EXPECT_EQ(rows(placement.agreeing), (std::vector<std::size_t>{0, 1, 3}));
  EXPECT_EQ(placement.rivals, 1U);
}

TEST_F(SubmapLinks, ARivalPlaceLeavesItOpen) {
  for (const std::size_t i : {0U, 1U, 2U}) link(i);
  for (const std::size_t i : {3U, 4U}) link(i, at(6, 0));
  EXPECT_EQ(place().keyframes, 3U);
  EXPECT_EQ(place().rivals, 2U);
  EXPECT_FALSE(place().is_certain(options_));
}

TEST_F(SubmapLinks, OfNothingAreNot) { EXPECT_FALSE(place().is_certain(options_)); }

TEST_F(SubmapLinks, JoinTheLaterSubmapToTheEarlierOne) {
  for (const std::size_t i : {0U, 1U}) link(i);
  EXPECT_FALSE(find_join(links_, map_, options_));
  link(2);
  const auto join = find_join(links_, map_, options_);
  ASSERT_TRUE(join);
  EXPECT_EQ(join->moved, 1);
  EXPECT_LT((join->T_new_old.inverse() * T_worlds_).log().norm(), 1e-12);
  EXPECT_EQ(join->links.size(), 3U);
  add_edge(EdgeKind::kLoop, 0, 10 * kKeyframes);
  EXPECT_FALSE(find_join(links_, map_, options_)) << "they are joined";
}

TEST_F(SubmapLinks, SeparateASubmapThatFewerKeyframesJoined) {
  add_edge(EdgeKind::kOdometry, 50, 60);
  add_edge(EdgeKind::kLoop, 0, 50);
  add_edge(EdgeKind::kLoop, 10, 60);
  add_edge(EdgeKind::kProximity, 0, 60);
  for (const std::size_t i : {2U, 3U}) link(i);
  EXPECT_FALSE(find_separation(links_, map_, options_));
  link(4);
  const auto separation = find_separation(links_, map_, options_);
  ASSERT_TRUE(separation);
  EXPECT_EQ(separation->keyframes, 3U);
  EXPECT_EQ(separation->edges, (std::vector<std::size_t>{3, 2, 1})) << "not the odometry edge";
}

TEST(Submaps, ShareTheNameOfTheFirst) {
  Submaps submaps;
  EXPECT_EQ(submaps.name_of(3), 3);
  submaps.join(3, 2);
  submaps.join(5, 4);
  EXPECT_EQ(submaps.name_of(3), 2);
  submaps.join(3, 5);
  for (const int submap : {2, 3, 4, 5}) EXPECT_EQ(submaps.name_of(submap), 2);
  submaps.join(1, 5);
  for (const int submap : {1, 2, 3, 4, 5}) EXPECT_EQ(submaps.name_of(submap), 1);
}

}  // namespace
}  // namespace cvo_slam
