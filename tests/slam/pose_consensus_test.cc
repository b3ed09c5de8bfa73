// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "cvo_slam/slam/relocalization_internal.h"

namespace cvo_slam {
namespace {

constexpr double kMaxSpeed = 3;         // [m/s]
constexpr double kMaxAngularSpeed = 6;  // [rad/s]

/// Adds the pose of a frame that was taken after so many seconds; returns true if enough agree.
bool add(PoseConsensus& consensus, double seconds, double x, int submap = 0) {
  RecognizedPose pose;
  pose.submap = submap;
  pose.T_world_camera = SE3(Matrix3::Identity(), {x, 0, 0});
  return consensus.add(Timestamp::from_seconds(100 + seconds), pose);
}

TEST(PoseConsensus, ThreeOnOnePathAgree) {
  PoseConsensus consensus(3, kMaxSpeed, kMaxAngularSpeed);
  EXPECT_FALSE(add(consensus, 0, 1));
  EXPECT_FALSE(add(consensus, 0.033, 1.05));
  EXPECT_TRUE(add(consensus, 0.1, 1.2));
}

TEST(PoseConsensus, AnotherPlaceStartsAgain) {
  PoseConsensus consensus(3, kMaxSpeed, kMaxAngularSpeed);
  EXPECT_FALSE(add(consensus, 0, 1));
  EXPECT_FALSE(add(consensus, 0.033, 1));
  EXPECT_FALSE(add(consensus, 0.066, 7));
  EXPECT_EQ(consensus.count(), 1);
  EXPECT_FALSE(add(consensus, 0.1, 7, 2)) << "in another submap's world";
  EXPECT_EQ(consensus.count(), 1);
}

TEST(PoseConsensus, OldPosesDoNotCount) {
  PoseConsensus consensus(2, kMaxSpeed, kMaxAngularSpeed);
  EXPECT_FALSE(add(consensus, 0, 1));
  EXPECT_FALSE(add(consensus, 1, 1));
}

TEST(PoseConsensus, CanBeCleared) {
  PoseConsensus consensus(2, kMaxSpeed, kMaxAngularSpeed);
  EXPECT_FALSE(add(consensus, 0, 1));
  consensus.clear();
  EXPECT_FALSE(add(consensus, 0.033, 1));
}

}  // namespace
}  // namespace cvo_slam
