// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Stretches of real sequences with the default options.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "cvo_slam/core/trajectory_errors.h"
#include "cvo_slam/frontend/tracker.h"
#include "cvo_slam/io/dataset.h"
#include "cvo_slam/tests/test_data.h"

namespace cvo_slam {
namespace {

/// Tracks `count` frames, every `step`-th one from the first.
Trajectory track(const Dataset& data, std::size_t first, std::size_t count, std::size_t step = 1) {
  Tracker tracker(data.camera());
  std::vector<FrameRecord> records;
  for (std::size_t i = 0; i < count; ++i) {
    records.push_back(tracker.track(data.read(first + step * i)).record);
  }
  return to_trajectory(records);
}

/// RPE over one second, poses matched to the nearest sample of the reference: the protocol of the
/// figures it is compared with.
PoseErrorStatistics error_of(const Dataset& data, const Trajectory& trajectory) {
  const auto matches = associate(data.reference(), trajectory.poses);
  return relative_pose_error(matches, {.delta = 1, .unit = DeltaUnit::kSeconds}).statistics;
}

constexpr double kDegree = M_PI / 180;

TEST(TrackerOnRealData, FollowsTumFr1Rpy) {
  constexpr const char* kSequence = "tum/rgbd_dataset_freiburg1_rpy";
  CVO_SLAM_REQUIRE_DATA(kSequence);
  const auto data = open_dataset(test_data() / kSequence);
  // Its third and fourth second: the first two are harder than the sequence is on average.
  const Trajectory trajectory = track(*data, 60, 60);
  EXPECT_TRUE(trajectory.lost.empty());
  const auto error = error_of(*data, trajectory);
  EXPECT_GE(error.translation.count, 25U);
  // The authors' own code over the whole sequence: 45.5 mm and 3.34 degrees.
  EXPECT_LT(error.translation.rmse, 0.0455);
  EXPECT_LT(error.rotation.rmse, 3.34 * kDegree);
}

TEST(TrackerOnRealData, FollowsFastTurnsAtTenFramesASecond) {
  constexpr const char* kSequence = "tum/rgbd_dataset_freiburg1_rpy";
  CVO_SLAM_REQUIRE_DATA(kSequence);
  DatasetOptions options;
  options.depth_offset = -0.019;
  const auto data = open_dataset(test_data() / kSequence, options);
  // Its first eight seconds, in which the camera leaves its predicted way. From the fine length
  // scales alone, frames end in another maximum without a word, and the error is 6.2 degrees.
  const Trajectory trajectory = track(*data, 0, 80, 3);
  EXPECT_TRUE(trajectory.lost.empty());
  EXPECT_LT(error_of(*data, trajectory).rotation.rmse, 3 * kDegree);
}

TEST(TrackerOnRealData, FollowsSevenScenes) {
  constexpr const char* kSequence = "7scenes/seq-01";
  CVO_SLAM_REQUIRE_DATA(kSequence);
  const auto data = open_dataset(test_data() / kSequence);
  const Trajectory trajectory = track(*data, 0, 35);
  EXPECT_TRUE(trajectory.lost.empty());
  const auto error = error_of(*data, trajectory);
  EXPECT_GE(error.translation.count, 5U);
  // The authors' own code over the whole sequence, its depth registered alike: 37.2 mm and 1.75
  // degrees. The first second is calm.
  EXPECT_LT(error.translation.rmse, 0.5 * 0.0372);
  EXPECT_LT(error.rotation.rmse, 0.5 * 1.75 * kDegree);
}

}  // namespace
}  // namespace cvo_slam
