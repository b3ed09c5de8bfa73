// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Recordings with few frames a second: features find where registrations start.
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "cvo_slam/core/association.h"
#include "cvo_slam/core/map.h"
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

constexpr const char* kFastTurns = "tum/rgbd_dataset_freiburg1_rpy";

std::unique_ptr<Dataset> open_fast_turns() {
  DatasetOptions options;
  options.depth_offset = -0.019;
  return open_dataset(test_data() / kFastTurns, options);
}

// The camera turns by up to 25 degrees between two frames at five of them a second, by 35 at four,
// and blurs.
TEST(LowRate, TheTurnOfTheImageAndFeaturesKeepFastTurnsTracked) {
  CVO_SLAM_REQUIRE_DATA(kFastTurns);
  const auto data = open_fast_turns();
  for (const auto& [step, with_features] : {std::pair{6, false}, {6, true}, {8, true}}) {
    SCOPED_TRACE(testing::Message() << "every " << step << "th, features " << with_features);
    const LowRateRun run = track_every(*data, static_cast<std::size_t>(step), with_features);
    EXPECT_EQ(run.lost, 0U);
    EXPECT_LT(kDegrees * run.rotation, 1.5);
  }
}

// With big steps, where other starts are looked for, threads, schedules and interrupted sessions
// must not change a bit either.
TEST(LowRate, NothingChangesABit) {
  CVO_SLAM_REQUIRE_DATA(kFastTurns);
  const auto data = open_fast_turns();
  std::vector<RgbdFrame> frames;
  for (std::size_t i = 90; i < 270; i += 6) frames.push_back(data->read(i));
  bool features_asked = false;
  const auto poses = [&](const SlamOptions& options, bool is_interrupted) {
    std::optional<Slam> slam(std::in_place, data->camera(), options);
    for (std::size_t i = 0; i < frames.size(); ++i) {
      features_asked |= slam->track(frames[i]).features_asked;
      if (!is_interrupted || i % 7 != 3) continue;
      const Map map = slam->map(MapContent::kSession);
      slam.emplace(map, options, MapUse::kResume);
    }
    slam->finish();
    std::vector<double> numbers;
    for (const StampedPose& pose : slam->trajectory().poses) {
      const auto matrix = pose.T_world_camera.matrix();
      numbers.insert(numbers.end(), matrix.data(), matrix.data() + matrix.size());
    }
    return numbers;
  };
  SlamOptions options;
  const auto expected = poses(options, false);
  EXPECT_TRUE(features_asked);
  EXPECT_TRUE(poses(options, true) == expected) << "interrupted";
  options.schedule = Schedule::kPipelined;
  for (const int threads : {2, 8}) {
    options.tracker.threads = threads;
    const bool is_interrupted = threads == 2;
    EXPECT_TRUE(poses(options, is_interrupted) == expected) << threads << " threads";
  }
}

}  // namespace
}  // namespace cvo_slam
