// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The tracker on exact images of a known walk.
#include "cvo_slam/frontend/tracker.h"

#include <algorithm>
#include <random>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/tests/frontend/synthetic_frames.h"
#include "cvo_slam/tests/frontend/test_frames.h"
#include "cvo_slam/tests/frontend/tracker_test_options.h"

namespace cvo_slam {
namespace {

using testing::Contains;

class TrackerOnSyntheticFrames : public testing::Test {
 protected:
  /// Returns the tracker's records of the first frames of the walk.
  [[nodiscard]] std::vector<FrameRecord> track(std::size_t count,
                                               const TrackerOptions& options) const {
    Tracker tracker(frames_.camera(), options);
    std::vector<FrameRecord> records;
    for (std::size_t i = 0; i < count; ++i)
      records.push_back(tracker.track(frames_.frame(i)).record);
    return records;
  }

  void expect_exact_poses(const std::vector<FrameRecord>& records, double translation,
                          double rotation) const {
    for (const FrameRecord& record : records) {
      SCOPED_TRACE(record.index);
      EXPECT_EQ(record.status, TrackingStatus::kTracked) << record.reason;
      EXPECT_EQ(record.reason, "");
      EXPECT_EQ(record.submap, 0);
      const SE3 error = frames_.T_first_camera(0, record.index).inverse() * record.T_world_camera;
      EXPECT_LT(error.translation().norm(), translation);
      EXPECT_LT(error.angle(), rotation);
    }
  }

  SyntheticFrames frames_{small_camera(320, 240)};
  TrackerOptions options_ = tracker_test_options();
};

// The tolerance is a pixel, because points lie at whole pixels: 1 / 262 rad, or 8 mm at the 2 m of
// the room's walls.
constexpr double kRotation = 1 / 262.5;
constexpr double kTranslation = 2 * kRotation;

TEST_F(TrackerOnSyntheticFrames, FollowsTheExactPoses) {
  const auto records = track(12, options_);
  expect_exact_poses(records, kTranslation, kRotation);
  for (const FrameRecord& record : records) {
    EXPECT_EQ(record.stamp, frames_.frame(record.index).stamp);
    EXPECT_EQ(record.points, 500U);
    EXPECT_GT(record.registration.overlap, 0.5);
  }
  const SE3 moved = frames_.T_first_camera(0, 11);
  EXPECT_GT(moved.translation().norm(), 5 * kTranslation) << "standing still would not do";
  EXPECT_GT(moved.angle(), 5 * kRotation);
}

TEST_F(TrackerOnSyntheticFrames, TheFirstFrameIsTheOriginAndAKeyframe) {
  const FrameRecord record = track(1, options_).front();
  EXPECT_EQ(record.status, TrackingStatus::kTracked);
  EXPECT_EQ(record.T_world_camera.matrix(), SE3().matrix());
  EXPECT_EQ(record.keyframe, 0U);
  EXPECT_EQ(record.keyframe_reason, "start of a submap");
  EXPECT_EQ(record.registration.overlap, 1.0);
}

/// Returns the frame without 30 % of its depth, in patches that differ from frame to frame.
RgbdFrame with_missing_depth(const RgbdFrame& frame) {
  constexpr int kPatch = 12;  // [px]
  RgbdFrame result = frame;
  result.depth = frame.depth.clone();
  std::mt19937 rng(static_cast<unsigned>(frame.index));
  for (int v = 0; v < frame.depth.rows; v += kPatch) {
    for (int u = 0; u < frame.depth.cols; u += kPatch) {
      if (rng() % 10 >= 3) continue;
      const cv::Rect patch(u, v, kPatch, kPatch);
      result.depth(patch & cv::Rect({}, frame.depth.size())).setTo(0);
    }
  }
  return result;
}

// Half of the points find no partner (0.7 of 0.7 do) however near the keyframe is.
TEST_F(TrackerOnSyntheticFrames, MissingDepthIsNoReasonForAKeyframe) {
  options_.keyframe.min_overlap = 0.8;
  Tracker tracker(frames_.camera(), options_);
  std::vector<FrameRecord> records;
  for (std::size_t i = 0; i < 12; ++i) {
    records.push_back(tracker.track(with_missing_depth(frames_.frame(i))).record);
  }
  expect_exact_poses(records, 2 * kTranslation, 2 * kRotation);  // from half of the pairs
  const auto of_overlap = std::count_if(records.begin(), records.end(), [](const FrameRecord& r) {
    return r.keyframe_reason == "overlap";
  });
  EXPECT_LE(of_overlap, 2);
  EXPECT_LT(records[1].registration.overlap, options_.keyframe.min_overlap);
}

TEST_F(TrackerOnSyntheticFrames, TakesKeyframesForTheReasonThatItGives) {
  const auto reasons_with = [&](const auto& change) {
    TrackerOptions options = options_;
    options.keyframe = {.min_overlap = 0, .max_translation = 100, .max_rotation = 4};
    change(options.keyframe);
    std::vector<std::string> reasons;
    for (const auto& record : track(3, options)) reasons.push_back(record.keyframe_reason);
    return reasons;
  };
  using Reasons = std::vector<std::string>;
  const std::string start = "start of a submap";
  EXPECT_EQ(reasons_with([](auto&) {}), (Reasons{start, "", ""}));
  EXPECT_THAT(reasons_with([](auto& k) { k.min_overlap = 1; }), Contains("overlap"));
  EXPECT_EQ(reasons_with([](auto& k) { k.max_translation = 1e-6; }),
            (Reasons{start, "translation", "translation"}));
  EXPECT_EQ(reasons_with([](auto& k) { k.max_rotation = 1e-6; }),
            (Reasons{start, "rotation", "rotation"}));
}

TEST_F(TrackerOnSyntheticFrames, RegistersAgainstTheKeyframe) {
  options_.keyframe = {.min_overlap = 0, .max_translation = 100, .max_rotation = 4};
  for (const auto& record : track(4, options_)) {
    EXPECT_EQ(record.keyframe, 0U);
    // The first keyframe is the world.
    EXPECT_LT((record.registration.T_fixed_moving.inverse() * record.T_world_camera).log().norm(),
              1e-12);
  }
}

TEST_F(TrackerOnSyntheticFrames, RegistersAgainstThePreviousFrameIfAskedTo) {
  options_.reference = Reference::kPreviousFrame;
  const auto records = track(5, options_);
  // Errors of frames add up: four of them here.
  expect_exact_poses(records, 4 * kTranslation, 4 * kRotation);
  for (std::size_t i = 1; i < records.size(); ++i) {
    EXPECT_EQ(records[i].keyframe, i - 1);
    EXPECT_EQ(records[i].keyframe_reason, "previous frame");
  }
}

TEST_F(TrackerOnSyntheticFrames, StartsFromThePredictionThatIsAskedFor) {
  for (const Prediction prediction : {Prediction::kConstantVelocity, Prediction::kIdentity}) {
    options_.prediction = prediction;
    expect_exact_poses(track(4, options_), kTranslation, kRotation);
  }
}

TEST_F(TrackerOnSyntheticFrames, FollowsWithThePapersProtocol) {
  TrackerOptions options = paper_options();
  options.points = options.keyframe_points = 800;  // of a quarter of the paper's pixels
  const auto records = track(4, options);
  // The linear kernel of colours hardly tells points apart, and errors of frames add up.
  expect_exact_poses(records, 0.02, 0.01);
  EXPECT_GT(records.back().registration.iterations, 20) << "the scales of the table at least";
}

TEST_F(TrackerOnSyntheticFrames, IsTheSameToTheBitWithTwoThreads) {
  const auto one = track(4, options_);
  options_.threads = 2;
  const auto two = track(4, options_);
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].T_world_camera.matrix(), two[i].T_world_camera.matrix());
    EXPECT_EQ(one[i].registration.covariance, two[i].registration.covariance);
    EXPECT_EQ(one[i].registration.iterations, two[i].registration.iterations);
  }
}

TEST_F(TrackerOnSyntheticFrames, SurfacesOfCleanDepthTellThePoseBetter) {
  const auto error_with = [this](bool surfaces) {
    options_.registration.kernel.surfaces = surfaces;
    double sum = 0;
    for (const FrameRecord& record : track(12, options_)) {
      const SE3 truth = frames_.T_first_camera(0, record.index);
      sum += (truth.inverse() * record.T_world_camera).translation().norm();
    }
    return sum;
  };
  EXPECT_LT(error_with(true), 0.5 * error_with(false));
}

TEST_F(TrackerOnSyntheticFrames, TracksGreyImages) {
  Tracker tracker(frames_.camera(), options_);
  std::vector<FrameRecord> records;
  for (std::size_t i = 0; i < 4; ++i) {
    RgbdFrame frame = frames_.frame(i);
    cv::extractChannel(frame.color, frame.color, 1);
    records.push_back(tracker.track(frame).record);
  }
  expect_exact_poses(records, kTranslation, kRotation);
}

TEST_F(TrackerOnSyntheticFrames, ImagesMayBeOverwrittenAfterTheCall) {
  // Grabbers write every image into the same memory. The tracker returns to the last tracked frame
  // if a frame resembles the keyframe too little, as here from the fourth frame on.
  options_.keyframe = {.min_overlap = 0, .max_translation = 100, .max_rotation = 4};
  options_.lost.min_cos_theta = 0.47;
  const auto expected = track(6, options_);
  EXPECT_GT(expected.back().keyframe, 0U) << "a frame was made a keyframe afterwards";
  Tracker tracker(frames_.camera(), options_);
  RgbdFrame buffer = frames_.frame(0);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const RgbdFrame frame = frames_.frame(i);
    frame.color.copyTo(buffer.color);
    frame.depth.copyTo(buffer.depth);
    buffer.index = frame.index;
    buffer.stamp = buffer.depth_stamp = frame.stamp;
    EXPECT_EQ(tracker.track(buffer).record.T_world_camera.matrix(),
              expected[i].T_world_camera.matrix());
  }
}

TEST(Tracker, AnObjectThatWasMovedFromSaysSo) {
  Tracker tracker{Camera()};
  const Tracker other = std::move(tracker);
  EXPECT_THROW(tracker.track({}), UsageError);  // NOLINT(bugprone-use-after-move)
  Registration registration;
  const Registration another = std::move(registration);
  // NOLINTNEXTLINE(bugprone-use-after-move)
  EXPECT_THROW(std::ignore = registration.align({}, {}), UsageError);
}

TEST(Tracker, RejectsImpossibleCamerasAndOptions) {
  const auto with = [](const auto& change) {
    TrackerOptions options = tracker_test_options();
    Camera camera = small_camera();
    change(camera, options);
    Tracker tracker(camera, options);
  };
  EXPECT_NO_THROW(with([](auto&, auto&) {}));
  EXPECT_THROW(with([](auto& c, auto&) { c.color.width = 0; }), OptionError);
  EXPECT_THROW(with([](auto& c, auto&) { c.color.fx = 0; }), OptionError);
  EXPECT_THROW(with([](auto& c, auto&) { c.depth_scale = 0; }), OptionError);
  EXPECT_THROW(with([](auto&, auto& o) { o.points = 0; }), OptionError);
  EXPECT_THROW(with([](auto&, auto& o) { o.threads = 0; }), OptionError);
  EXPECT_THROW(with([](auto&, auto& o) { o.keyframe.min_overlap = 2; }), OptionError);
  EXPECT_THROW(with([](auto&, auto& o) { o.lost.restart_time = -1; }), OptionError);
  EXPECT_THROW(with([](auto&, auto& o) { o.selection.max_depth = -1; }), OptionError);
  EXPECT_THROW(with([](auto&, auto& o) { o.registration.length_scales.clear(); }), OptionError);
}

}  // namespace
}  // namespace cvo_slam
