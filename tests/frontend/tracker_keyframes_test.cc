// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Keyframes as the tracker hands them out, and how tracking resumes at a recognised pose.
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/frontend/tracker.h"
#include "cvo_slam/tests/frontend/synthetic_frames.h"
#include "cvo_slam/tests/frontend/test_frames.h"
#include "cvo_slam/tests/frontend/tracker_test_options.h"

namespace cvo_slam {
namespace {

using ::testing::HasSubstr;

class TrackerKeyframes : public testing::Test {
 protected:
  static constexpr std::size_t kElsewhere = 150;  // another wall

  TrackerKeyframes() {
    // No keyframe but the first one of a submap.
    options_.keyframe = {.min_overlap = 0, .max_translation = 100, .max_rotation = 4};
    options_.lost.restart_time = 0.1;
  }

  void make_every_frame_a_keyframe() { options_.keyframe.max_translation = 1e-6; }
  void start() { tracker_ = Tracker(frames_.camera(), options_); }
  TrackedFrame track(std::size_t index) { return tracker_.track(frames_.frame(index)); }
  TrackedFrame lose(std::size_t index) {
    TrackedFrame tracked = tracker_.track(frames_.frame(index, kElsewhere));
    EXPECT_EQ(tracked.record.status, TrackingStatus::kLost);
    return tracked;
  }
  static void expect_frame(const std::optional<TrackerKeyframe>& keyframe, std::size_t frame) {
    ASSERT_TRUE(keyframe.has_value());
    EXPECT_EQ(keyframe->frame, frame);
    EXPECT_EQ(keyframe->images.index, frame);
    ASSERT_NE(keyframe->cloud, nullptr);
    EXPECT_EQ(keyframe->cloud->size(), 2000U);
  }

  SyntheticFrames frames_{small_camera(320, 240)};
  TrackerOptions options_ = tracker_test_options();
  Tracker tracker_{frames_.camera(), options_};
};

TEST_F(TrackerKeyframes, AreReturnedOnceAFrameWasRegisteredToThem) {
  make_every_frame_a_keyframe();
  start();
  EXPECT_FALSE(track(0).keyframe.has_value());
  for (std::size_t i = 1; i < 6; ++i) {
    const TrackedFrame tracked = track(i);
    EXPECT_EQ(tracked.record.keyframe, i - 1);
    expect_frame(tracked.keyframe, i - 1);
  }
}

TEST_F(TrackerKeyframes, AreReturnedOnce) {
  start();
  EXPECT_FALSE(track(0).keyframe.has_value());
  expect_frame(track(1).keyframe, 0);
  for (std::size_t i = 2; i < 5; ++i) EXPECT_FALSE(track(i).keyframe.has_value());
  EXPECT_FALSE(tracker_.take_keyframe().has_value());
}

TEST_F(TrackerKeyframes, ThatWereTakenAreNotReturnedAgain) {
  make_every_frame_a_keyframe();
  start();
  track(0);
  expect_frame(tracker_.take_keyframe(), 0);
  EXPECT_FALSE(tracker_.take_keyframe().has_value());
  EXPECT_FALSE(track(1).keyframe.has_value()) << "made again with the motion, but known already";
  expect_frame(track(2).keyframe, 1);
}

TEST_F(TrackerKeyframes, WaitWhileFramesAreLost) {
  start();
  track(0);
  EXPECT_FALSE(lose(1).keyframe.has_value());
  EXPECT_FALSE(lose(2).keyframe.has_value());
  expect_frame(track(3).keyframe, 0);
}

TEST_F(TrackerKeyframes, AreReturnedWhenANewSubmapStarts) {
  start();
  track(0);
  lose(1);
  lose(2);
  lose(3);
  const TrackedFrame restarted = tracker_.track(frames_.frame(4, kElsewhere));
  EXPECT_EQ(restarted.record.submap, 1);
  expect_frame(restarted.keyframe, 0);
  expect_frame(tracker_.take_keyframe(), 4);
}

TEST_F(TrackerKeyframes, AnEarlierFrameThatBecameOneIsReturnedToo) {
  options_.lost.min_cos_theta = 0.47;  // only neighbours are so similar
  start();
  std::vector<TrackedFrame> tracked;
  for (std::size_t i = 0; i < 6; ++i) tracked.push_back(track(i));
  std::size_t promoted = 0;
  for (const TrackedFrame& frame : tracked) {
    if (!frame.record.promoted_keyframe) continue;
    ++promoted;
    expect_frame(frame.keyframe, *frame.record.promoted_keyframe);
  }
  EXPECT_GT(promoted, 0U);
}

TEST_F(TrackerKeyframes, KeepTheirImagesWhileTrackingGoesOn) {
  make_every_frame_a_keyframe();
  start();
  std::vector<TrackerKeyframe> keyframes;
  for (std::size_t i = 0; i < 6; ++i) {
    if (auto keyframe = track(i).keyframe) keyframes.push_back(*keyframe);
  }
  ASSERT_EQ(keyframes.size(), 5U);
  for (const TrackerKeyframe& keyframe : keyframes) {
    const RgbdFrame expected = frames_.frame(keyframe.frame);
    EXPECT_EQ(cv::norm(keyframe.images.color, expected.color, cv::NORM_INF), 0);
    EXPECT_EQ(cv::norm(keyframe.images.depth, expected.depth, cv::NORM_INF), 0);
    EXPECT_EQ(keyframe.images.stamp, expected.stamp);
  }
}

TEST_F(TrackerKeyframes, ALostFrameIsResumedAtAPose) {
  start();
  track(0);
  lose(1);
  const SE3 T_world_camera(Matrix3::Identity(), {1, 2, 3});
  expect_frame(tracker_.take_keyframe(), 0);
  const FrameRecord resumed = tracker_.resume(T_world_camera);
  EXPECT_EQ(resumed.status, TrackingStatus::kTracked);
  EXPECT_EQ(resumed.index, 1U);
  EXPECT_EQ(resumed.stamp, frames_.frame(1).stamp);
  EXPECT_EQ(resumed.submap, 1);
  EXPECT_EQ(resumed.keyframe, 1U);
  EXPECT_EQ(resumed.T_world_camera.matrix(), T_world_camera.matrix());
  const TrackedFrame next = tracker_.track(frames_.frame(2, kElsewhere + 1));
  expect_frame(next.keyframe, 1);
  EXPECT_EQ(next.record.submap, 1);
  const SE3 moved = T_world_camera * frames_.T_first_camera(kElsewhere, kElsewhere + 1);
  EXPECT_LT((moved.inverse() * next.record.T_world_camera).translation().norm(), 0.008)
      << "a pixel at 2 m";
}

TEST_F(TrackerKeyframes, OnlyALostFrameWithUsableImagesIsResumed) {
  start();
  EXPECT_THAT(tracker_.resume(SE3()).reason, HasSubstr("no frame"));
  track(0);
  EXPECT_EQ(tracker_.resume(SE3()).status, TrackingStatus::kLost);
  EXPECT_THAT(tracker_.resume(SE3()).reason, HasSubstr("tracked already"));
  RgbdFrame bad = frames_.frame(1);
  bad.color.release();
  tracker_.track(bad);
  EXPECT_THAT(tracker_.resume(SE3()).reason, HasSubstr("empty"));
  EXPECT_TRUE(tracker_.select_keyframe_points().empty());
  RgbdFrame blank = frames_.frame(2);
  blank.depth.setTo(0);
  tracker_.track(blank);
  EXPECT_THAT(tracker_.resume(SE3()).reason, HasSubstr("only 0 points"));
}

TEST_F(TrackerKeyframes, PointsOfALostFrameHaveTheExposureTakenOut) {
  start();
  track(0);
  lose(1);
  const PointCloud before = tracker_.select_keyframe_points();
  ASSERT_EQ(before.size(), 2000U);
  RgbdFrame darker = frames_.frame(2, kElsewhere);
  darker.color.convertTo(darker.color, -1, 0.5);
  ASSERT_EQ(tracker_.track(darker).record.status, TrackingStatus::kLost);
  const PointCloud after = tracker_.select_keyframe_points();
  const auto mean = [](const PointCloud& cloud) {
    double sum = 0;
    for (const float green : cloud.features[1]) sum += green;
    return sum / static_cast<double>(cloud.size());
  };
  // Half of the contrast leaves other pixels, of about the same mean.
  EXPECT_NEAR(mean(after), mean(before), 0.1 * mean(before));
}

}  // namespace
}  // namespace cvo_slam
