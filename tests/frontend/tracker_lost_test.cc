// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Frames that cannot be tracked, and the frames after them.
#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/frontend/tracker.h"
#include "cvo_slam/frontend/tracking_judgement_internal.h"
#include "cvo_slam/tests/frontend/synthetic_frames.h"
#include "cvo_slam/tests/frontend/test_frames.h"
#include "cvo_slam/tests/frontend/tracker_test_options.h"

namespace cvo_slam {
namespace {

using ::testing::AnyOf;
using ::testing::HasSubstr;

class LostFrames : public testing::Test {
 protected:
  static constexpr double kPixel = 1 / 262.5;  // [rad]
  /// Number of frames to another wall, halfway round the room.
  static constexpr std::size_t kElsewhere = 150;

  FrameRecord track(std::size_t index) { return tracker_.track(frames_.frame(index)).record; }

  /// Tracks frame `index` after `change` to it.
  FrameRecord track_changed(std::size_t index, const std::function<void(RgbdFrame&)>& change) {
    RgbdFrame frame = frames_.frame(index);
    change(frame);
    return tracker_.track(frame).record;
  }

  static void expect_lost(const FrameRecord& record, const std::string& reason) {
    EXPECT_EQ(record.status, TrackingStatus::kLost);
    EXPECT_THAT(record.reason, HasSubstr(reason));
    EXPECT_EQ(record.keyframe_reason, "");
  }

  void expect_tracked(const FrameRecord& record) const {
    EXPECT_EQ(record.status, TrackingStatus::kTracked) << record.reason;
    const SE3 error = frames_.T_first_camera(0, record.index).inverse() * record.T_world_camera;
    EXPECT_LT(error.translation().norm(), 2 * kPixel);  // at the 2 m of the room's walls
    EXPECT_LT(error.angle(), kPixel);
  }

  void use(const TrackerOptions& options) { tracker_ = Tracker(frames_.camera(), options); }

  SyntheticFrames frames_{small_camera(320, 240)};
  TrackerOptions options_ = tracker_test_options();
  Tracker tracker_{frames_.camera(), options_};
};

TEST_F(LostFrames, BadImagesAreLostWithAReasonAndTrackingGoesOn) {
  expect_tracked(track(0));
  expect_lost(track_changed(1, [](auto& f) { f.problem = "rgb/1.png: cannot be read"; }),
              "rgb/1.png: cannot be read");
  expect_lost(track_changed(2, [](auto& f) { f.color = cv::Mat(); }), "colour image is empty");
  expect_lost(track_changed(2, [](auto& f) { f.depth = cv::Mat(); }), "depth image is empty");
  expect_tracked(track(2));
  expect_lost(track_changed(3, [](auto& f) { f.color = f.color.colRange(0, 300).clone(); }),
              "300x240");
  expect_lost(track_changed(3, [](auto& f) { f.depth.convertTo(f.depth, CV_32F); }), "16 bits");
  expect_lost(track_changed(3, [](auto& f) { f.color.convertTo(f.color, CV_32F); }), "8 bits");
  expect_tracked(track(3));
}

TEST_F(LostFrames, ImagesWithoutPointsAreLost) {
  expect_tracked(track(0));
  const std::string reason = "only 0 points with gradient and depth";
  expect_lost(track_changed(1, [](auto& f) { f.depth.setTo(0); }), reason);
  expect_lost(track_changed(2, [](auto& f) { f.color.setTo(cv::Scalar::all(90)); }), reason);
  expect_tracked(track(3));
  // A hand in front of the camera leaves a corner.
  const auto record = track_changed(4, [](auto& f) { f.depth.colRange(20, 320).setTo(0); });
  expect_lost(record, "points with gradient and depth");
  EXPECT_GT(record.points, 0U);
  expect_tracked(track(5));
}

TEST_F(LostFrames, BadImagesBeforeTheFirstGoodOneStartNothing) {
  expect_lost(track_changed(0, [](auto& f) { f.depth.setTo(0); }), "points");
  expect_lost(track_changed(0, [](auto& f) { f.color.release(); }), "empty");
  const FrameRecord record = track(1);
  EXPECT_EQ(record.status, TrackingStatus::kTracked);
  EXPECT_EQ(record.T_world_camera.matrix(), SE3().matrix());
  EXPECT_EQ(record.submap, 0);
}

TEST_F(LostFrames, StampsMustAscend) {
  expect_tracked(track(0));
  expect_tracked(track(2));
  expect_lost(track(1), "its stamp is not after the stamp 100.066667 of the last tracked frame");
  expect_lost(track(2), "its stamp is not after");
  expect_tracked(track(3));
}

TEST_F(LostFrames, OneStampFromTheFutureDoesNotLoseAllThatFollow) {
  options_.lost.restart_time = 0.1;
  options_.lost.max_speed = options_.lost.max_angular_speed = 1000;
  use(options_);
  expect_tracked(track(0));
  expect_tracked(track_changed(1, [](auto& f) { f.stamp = Timestamp::from_seconds(1e6); }));
  for (const std::size_t i : {2U, 3U, 4U}) expect_lost(track(i), "its stamp is not after");
  const FrameRecord restarted = track(5);
  EXPECT_EQ(restarted.status, TrackingStatus::kTracked);
  EXPECT_EQ(restarted.submap, 1);
  EXPECT_EQ(track(6).status, TrackingStatus::kTracked);
}

TEST_F(LostFrames, AFrameThatNeedsTheLastOneAsKeyframeSaysSo) {
  // The least overlap is one that only neighbouring frames have.
  options_.keyframe = {.min_overlap = 0, .max_translation = 100, .max_rotation = 4};
  use(options_);
  expect_tracked(track(0));
  double overlap = 1;
  for (std::size_t i = 1; i < 6; ++i) overlap = track(i).registration.overlap;
  options_.lost.min_overlap = overlap + 0.01;
  use(options_);
  std::vector<FrameRecord> records;
  for (std::size_t i = 0; i < 6; ++i) records.push_back(track(i));
  const auto promoted = std::find_if(records.begin(), records.end(), [](const FrameRecord& record) {
    return record.promoted_keyframe.has_value();
  });
  ASSERT_NE(promoted, records.end());
  EXPECT_EQ(*promoted->promoted_keyframe, promoted->index - 1);
  EXPECT_EQ(promoted->keyframe, promoted->index - 1);
  expect_tracked(*promoted);
}

TEST_F(LostFrames, AnAnswerMoreLikelyWrongThanRightIsAskedOfTheLastTrackedFrame) {
  // Only the doubt tells that a jump has left the keyframe nearly out of sight.
  options_.keyframe = {.min_overlap = 0, .max_translation = 100, .max_rotation = 4};
  options_.lost.min_overlap = options_.lost.min_cos_theta = 0;
  options_.lost.max_speed = options_.lost.max_angular_speed = 1000;
  use(options_);
  constexpr std::size_t kFrames = 10;
  for (std::size_t i = 0; i < kFrames; ++i) expect_tracked(track(i));
  // Against the first frame alone, the answer is 9 cm off.
  const FrameRecord record = tracker_.track(frames_.frame(kFrames, 28)).record;
  EXPECT_EQ(record.promoted_keyframe, kFrames - 1);
  EXPECT_EQ(record.keyframe, kFrames - 1);
  EXPECT_EQ(record.status, TrackingStatus::kTracked) << record.reason;
  const SE3 error = frames_.T_first_camera(0, 28).inverse() * record.T_world_camera;
  EXPECT_LT(error.translation().norm(), 2 * kPixel);
  EXPECT_LT(error.angle(), kPixel);
}

TEST_F(LostFrames, AJumpToAnotherPlaceIsLostAndTheWayBackIsFound) {
  expect_tracked(track(0));
  expect_tracked(track(1));
  const FrameRecord record = tracker_.track(frames_.frame(2, kElsewhere)).record;
  EXPECT_EQ(record.status, TrackingStatus::kLost);
  EXPECT_THAT(record.reason,
              AnyOf(HasSubstr("overlap"), HasSubstr("cos_theta"), HasSubstr("speed")));
  expect_tracked(track(3));
}

TEST_F(LostFrames, ADoubtfulMotionTooFastForAHandIsNotBelieved) {
  const LostOptions any_speed{.max_speed = 1000, .max_angular_speed = 1000};
  const auto track_second = [&](std::size_t place, const LostOptions& lost) {
    options_.lost = lost;
    use(options_);
    expect_tracked(track(0));
    return tracker_.track(frames_.frame(1, place)).record;
  };
  std::size_t place = 3;
  while (place < 30 && track_second(place, any_speed).doubt <= kDoubtful) ++place;
  ASSERT_LT(place, 30U);
  EXPECT_EQ(track_second(place, any_speed).status, TrackingStatus::kTracked);
  const double second = 1.0 / 30;
  const auto motion = [&](std::size_t to) { return frames_.T_first_camera(0, to); };
  LostOptions slow = any_speed;
  slow.max_speed = 0.5 * motion(place).translation().norm() / second;
  expect_lost(track_second(place, slow), "m/s is above");
  LostOptions steady = any_speed;
  steady.max_angular_speed = 0.5 * motion(place).angle() / second;
  expect_lost(track_second(place, steady), "rad/s is above");

  // Stamps may be counted: what is not doubtful otherwise may be as fast.
  slow.max_speed = 0.5 * motion(3).translation().norm() / second;
  steady.max_angular_speed = 0.5 * motion(3).angle() / second;
  EXPECT_EQ(track_second(3, slow).status, TrackingStatus::kTracked);
  EXPECT_EQ(track_second(3, steady).status, TrackingStatus::kTracked);
}

TEST_F(LostFrames, AResultThatIsNotLikeTheKeyframeIsNotBelieved) {
  options_.lost.min_overlap = 1;
  use(options_);
  expect_tracked(track(0));
  expect_lost(track(5), "overlap 0.");
  options_.lost.min_overlap = 0;
  options_.lost.min_cos_theta = 1;
  use(options_);
  expect_tracked(track(0));
  expect_lost(track(5), "cos_theta 0.");
}

TEST_F(LostFrames, ANewSubmapStartsAfterTooLong) {
  options_.lost.restart_time = 0.1;
  use(options_);
  std::vector<FrameRecord> records;
  for (std::size_t i = 0; i < 2; ++i) records.push_back(track(i));
  for (std::size_t i = 2; i < 10; ++i) {
    records.push_back(tracker_.track(frames_.frame(i, kElsewhere + i)).record);
  }
  for (const std::size_t i : {2U, 3U, 4U}) {
    EXPECT_EQ(records[i].status, TrackingStatus::kLost) << i;
    EXPECT_EQ(records[i].submap, 0);
  }
  for (std::size_t i = 5; i < 10; ++i) {
    EXPECT_EQ(records[i].status, TrackingStatus::kTracked) << records[i].reason;
    EXPECT_EQ(records[i].submap, 1);
    EXPECT_EQ(records[i].reason, "");
    // The path starts at the last known pose, relative to the submap's first frame.
    const SE3 moved =
        records[1].T_world_camera * frames_.T_first_camera(kElsewhere + 5, kElsewhere + i);
    EXPECT_LT((moved.inverse() * records[i].T_world_camera).translation().norm(), 2 * kPixel);
  }
  EXPECT_EQ(records[5].keyframe, 5U);
  EXPECT_EQ(records[5].keyframe_reason, "start of a submap");
  // The refused registration to the old keyframe is not in the record.
  EXPECT_EQ(records[5].registration.iterations, 0);
  EXPECT_EQ(records[5].registration.T_fixed_moving.matrix(), SE3().matrix());

  // The second submap has five frames, the first one two: the second one is the trajectory.
  const Trajectory trajectory = to_trajectory(records);
  ASSERT_EQ(trajectory.poses.size(), 5U);
  EXPECT_EQ(trajectory.poses.front().stamp, records[5].stamp);
  ASSERT_EQ(trajectory.lost.size(), 5U);
  EXPECT_THAT(trajectory.lost[0].reason, HasSubstr("submap 0 is not connected"));
  EXPECT_EQ(trajectory.lost[2].reason, records[2].reason);
}

// The time counts, whatever the frame rate; but so few frames are too few to be recognised in.
TEST_F(LostFrames, ANewSubmapStartsAfterTheSameTimeAtEveryRate) {
  constexpr double kRestart = 0.3;  // [s]
  const auto lost_frames = [&](double rate) {
    options_ = tracker_test_options();
    options_.lost.restart_time = kRestart;
    use(options_);
    const auto frame = [&](std::size_t i, std::size_t place) {
      RgbdFrame made = frames_.frame(i, place);
      made.stamp = made.depth_stamp = Timestamp::from_seconds(100 + static_cast<double>(i) / rate);
      return made;
    };
    std::ignore = tracker_.track(frame(0, 0));
    int lost = 0;
    while (tracker_.track(frame(static_cast<std::size_t>(lost) + 1, kElsewhere)).record.status ==
           TrackingStatus::kLost) {
      ++lost;
      if (lost > 100) break;
    }
    return lost;
  };
  EXPECT_EQ(lost_frames(120), 36) << "the 37th is 0.3 s after the first";
  EXPECT_EQ(lost_frames(30), 9);
  EXPECT_EQ(lost_frames(5), 3);
  EXPECT_EQ(lost_frames(1), 3);
}

TEST_F(LostFrames, LossesThatAreNotInARowDoNotRestart) {
  options_.lost.restart_time = 0;  // at the fourth
  use(options_);
  expect_tracked(track(0));
  for (std::size_t i = 1; i < 12; i += 2) {
    EXPECT_EQ(tracker_.track(frames_.frame(i, kElsewhere)).record.status, TrackingStatus::kLost);
    const FrameRecord record = track(i + 1);
    expect_tracked(record);
    EXPECT_EQ(record.submap, 0);
  }
}

TEST(ToTrajectory, OfNothingIsEmpty) {
  const Trajectory trajectory = to_trajectory({});
  EXPECT_TRUE(trajectory.poses.empty());
  EXPECT_TRUE(trajectory.lost.empty());
}

TEST(ToTrajectory, OfLostFramesHasNoPose) {
  FrameRecord record;
  record.reason = "dark";
  record.stamp = Timestamp(5);
  const Trajectory trajectory = to_trajectory({record});
  EXPECT_TRUE(trajectory.poses.empty());
  ASSERT_EQ(trajectory.lost.size(), 1U);
  EXPECT_EQ(trajectory.lost[0].stamp, Timestamp(5));
  EXPECT_EQ(trajectory.lost[0].reason, "dark");
}

TEST(ToTrajectory, OfTwoSubmapsOfOneLengthKeepsTheFirst) {
  std::vector<FrameRecord> records(4);
  for (std::size_t i = 0; i < records.size(); ++i) {
    records[i].stamp = Timestamp(static_cast<std::int64_t>(i));
    records[i].status = TrackingStatus::kTracked;
    records[i].submap = i < 2 ? 0 : 1;
  }
  const Trajectory trajectory = to_trajectory(records);
  ASSERT_EQ(trajectory.poses.size(), 2U);
  EXPECT_EQ(trajectory.poses[0].stamp, Timestamp(0));
  ASSERT_EQ(trajectory.lost.size(), 2U);
  EXPECT_EQ(trajectory.lost[0].reason, "submap 1 is not connected to the trajectory's submap 0");
}

// Half a second of a turn lies between two frames: CVO does not reach that far from the prediction.
TEST_F(LostFrames, AStartThatSomebodyFindsReachesFurther) {
  constexpr std::size_t kFar = 30;
  constexpr std::size_t kAskedFor = 31;
  std::size_t asked = 0;
  const StartFinder find_start = [&](const RgbdFrame& keyframe, const SE3&,
                                     const RgbdFrame& frame) {
    ++asked;
    return frames_.T_first_camera(keyframe.index, frame.index);
  };
  for (std::size_t i = 0; i < 3; ++i) tracker_.track(frames_.frame(i), find_start);
  EXPECT_EQ(asked, 0U) << "frames that follow one another need no help";
  expect_tracked(tracker_.track(frames_.frame(kFar), find_start).record);
  EXPECT_GT(asked, 0U);
  EXPECT_EQ(tracker_.track(frames_.frame(kAskedFor), find_start).record.keyframe, kFar);
  Tracker alone(frames_.camera(), options_);
  for (std::size_t i = 0; i < 3; ++i) alone.track(frames_.frame(i));
  EXPECT_EQ(alone.track(frames_.frame(kFar)).record.status, TrackingStatus::kLost);
}

// Whoever finds it may be wrong.
TEST_F(LostFrames, AFoundStartIsNotTakenBlindly) {
  const StartFinder find_nonsense = [](const RgbdFrame&, const SE3&, const RgbdFrame&) {
    return SE3(so3_exp({0, 1, 0}), {0.5, 0, 0});
  };
  const StartFinder find_nothing = [](const RgbdFrame&, const SE3&, const RgbdFrame&) {
    return std::optional<SE3>();
  };
  for (std::size_t i = 0; i < 3; ++i) tracker_.track(frames_.frame(i));
  // Two frame periods: the prediction is good, but somebody is asked.
  expect_tracked(tracker_.track(frames_.frame(5), find_nonsense).record);
  expect_tracked(tracker_.track(frames_.frame(8), find_nothing).record);
  expect_lost(tracker_.track(frames_.frame(60, kElsewhere), find_nonsense).record, "");
}

TEST_F(LostFrames, WhatFeaturesRefuseIsNotTakenFromAnotherStart) {
  const StartFinder find_nonsense = [](const RgbdFrame&, const SE3&, const RgbdFrame&) {
    return SE3(so3_exp({0, 1, 0}), {0.5, 0, 0});
  };
  options_.keyframe.max_translation = 0;  // each frame becomes the keyframe
  options_.lost.max_speed = options_.lost.max_angular_speed = 1000;
  use(options_);
  for (std::size_t i = 0; i < 3; ++i) expect_tracked(track(i));
  // An overlap that is enough for a frame, but not against what features say.
  const FrameRecord record = tracker_.track(frames_.frame(3, 24), find_nonsense).record;
  EXPECT_GT(record.registration.overlap, options_.lost.min_overlap);
  expect_lost(record, "the features of the images say that the camera is elsewhere");
}

}  // namespace
}  // namespace cvo_slam
