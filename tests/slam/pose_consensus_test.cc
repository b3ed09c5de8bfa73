// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "cvo_slam/slam/relocalization_internal.h"

namespace cvo_slam {
namespace {

constexpr double kMaxSpeed = 3;         // [m/s]
constexpr double kMaxAngularSpeed = 6;  // [rad/s]

RecognizedPose pose_at(double x, int submap = 0) {
  RecognizedPose pose;
  pose.submap = submap;
  pose.T_world_camera = SE3(Matrix3::Identity(), {x, 0, 0});
  return pose;
}

/// Adds the pose of a frame that was taken after so many seconds; returns true if enough agree.
bool add(PoseConsensus& consensus, double seconds, double x, int submap = 0) {
  constexpr double kPeriod = 0.033;  // [s]
  return consensus.add(Timestamp::from_seconds(100 + seconds), kPeriod, pose_at(x, submap));
}

/// Number of frames at a rate until a camera that stands still and is recognised is found.
int frames_until_found(double rate) {
  PoseConsensus consensus(3, kMaxSpeed, kMaxAngularSpeed);
  for (int i = 0; i < 100; ++i) {
    const auto stamp = Timestamp::from_seconds(100 + i / rate);
    if (consensus.add(stamp, 1 / rate, pose_at(1))) return i + 1;
  }
  return 0;
}

TEST(PoseConsensus, ComesAtEveryFrameRate) {
  EXPECT_EQ(frames_until_found(1), 3);
  EXPECT_EQ(frames_until_found(5), 3);
  EXPECT_EQ(frames_until_found(30), 3);
  EXPECT_EQ(frames_until_found(120), 9) << "images of less than 0.06 s say the same";
}

TEST(PoseConsensus, AtALowRateOneFrameMayMiss) {
  PoseConsensus consensus(3, kMaxSpeed, kMaxAngularSpeed);
  EXPECT_FALSE(consensus.add(Timestamp::from_seconds(100), 1, pose_at(1)));
  EXPECT_FALSE(consensus.add(Timestamp::from_seconds(102), 1, pose_at(1.1)));
  EXPECT_TRUE(consensus.add(Timestamp::from_seconds(104), 1, pose_at(1.2)));
  consensus.clear();
  EXPECT_FALSE(consensus.add(Timestamp::from_seconds(200), 1, pose_at(1)));
  EXPECT_FALSE(consensus.add(Timestamp::from_seconds(203), 1, pose_at(1)));
  EXPECT_FALSE(consensus.add(Timestamp::from_seconds(206), 1, pose_at(1))) << "too long ago";
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
