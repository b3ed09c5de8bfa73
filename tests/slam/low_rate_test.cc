// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Recordings with few frames a second: features find where registrations start.
#include <gtest/gtest.h>

#include "cvo_slam/core/association.h"
#include "cvo_slam/core/trajectory_errors.h"
#include "cvo_slam/io/dataset.h"
#include "cvo_slam/slam/slam.h"
#include "cvo_slam/tests/test_data.h"

namespace cvo_slam {
namespace {

struct LowRateRun {
  std::size_t lost = 0;
  double rotation = 0;  // RMSE of the RPE from frame to frame [rad]
};

/// Every n-th frame of the first seconds.
LowRateRun track_every(const Dataset& data, std::size_t step, bool with_features) {
  SlamOptions options;
  options.loops.enabled = with_features;
  Slam slam(data.camera(), options);
  LowRateRun run;
  for (std::size_t i = 0; i < 200; i += step) {
    run.lost += slam.track(data.read(i)).status == TrackingStatus::kLost ? 1 : 0;
  }
  slam.finish();
  AssociationOptions association;
  association.interpolate = true;
  const auto matches = associate(data.reference(), slam.trajectory().poses, association);
  const RelativePoseOptions from_frame_to_frame = {.unit = DeltaUnit::kFrames};
  run.rotation = relative_pose_error(matches, from_frame_to_frame).statistics.rotation.rmse;
  return run;
}

// The camera turns by up to 25 degrees between two frames at five of them a second, by 35 at four,
// and blurs.
TEST(LowRate, TheTurnOfTheImageAndFeaturesKeepFastTurnsTracked) {
  constexpr const char* kSequence = "tum/rgbd_dataset_freiburg1_rpy";
  CVO_SLAM_REQUIRE_DATA(kSequence);
  DatasetOptions options;
  options.depth_offset = -0.019;
  const auto data = open_dataset(test_data() / kSequence, options);
  for (const auto& [step, with_features] : {std::pair{6, false}, {6, true}, {8, true}}) {
    SCOPED_TRACE(testing::Message() << "every " << step << "th, features " << with_features);
    const LowRateRun run = track_every(*data, static_cast<std::size_t>(step), with_features);
    EXPECT_EQ(run.lost, 0U);
    EXPECT_LT(kDegrees * run.rotation, 1.5);
  }
}

}  // namespace
}  // namespace cvo_slam
