// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstddef>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "cvo_slam/frontend/exposure_internal.h"
#include "cvo_slam/frontend/tracker.h"
#include "cvo_slam/tests/frontend/synthetic_frames.h"
#include "cvo_slam/tests/frontend/test_frames.h"
#include "cvo_slam/tests/frontend/tracker_test_options.h"

namespace cvo_slam {
namespace {

cv::Mat scaled(const cv::Mat& image, double factor) {
  cv::Mat result;
  image.convertTo(result, -1, factor);
  return result;
}

class ExposureOfACamera : public testing::Test {
 protected:
  [[nodiscard]] cv::Mat image(std::size_t index) { return frames_.frame(index).color; }

  /// Tracks eight frames, of which those from the fifth on are brighter by a factor.
  [[nodiscard]] std::vector<FrameRecord> track_with_a_jump(const TrackerOptions& options,
                                                           double factor) {
    Tracker tracker(frames_.camera(), options);
    std::vector<FrameRecord> records;
    for (std::size_t i = 0; i < 8; ++i) {
      RgbdFrame frame = frames_.frame(i);
      if (i >= 4) frame.color = scaled(frame.color, factor);
      records.push_back(tracker.track(frame).record);
    }
    return records;
  }

  double gain(const cv::Mat& image) { return exposure_.update(image).gain; }

  SyntheticFrames frames_{small_camera(320, 240)};
  ExposureGain exposure_;
};

TEST_F(ExposureOfACamera, GainIsExactlyOneIfOnlyTheViewChanges) {
  for (std::size_t i = 0; i < 20; ++i) EXPECT_EQ(gain(image(i)), 1.0);
  EXPECT_EQ(gain(image(150)), 1.0) << "the other side of the room";
}

TEST_F(ExposureOfACamera, GainFollowsJumpsThatAddUpAndEnd) {
  gain(image(0));
  EXPECT_NEAR(gain(scaled(image(1), 0.5)), 0.5, 0.02);
  EXPECT_NEAR(gain(scaled(image(2), 0.5)), 0.5, 0.02);
  EXPECT_NEAR(gain(scaled(image(3), 0.3)), 0.3, 0.02);
  EXPECT_NEAR(gain(image(4)), 1, 0.03);
}

TEST_F(ExposureOfACamera, GainIsTheSameForGreyAndColouredImages) {
  double last = 1;
  for (const double factor : {1.0, 0.6}) {
    cv::Mat one_channel;
    cv::extractChannel(scaled(image(0), factor), one_channel, 1);
    last = gain(one_channel);
  }
  EXPECT_NEAR(last, 0.6, 0.02);
}

TEST_F(ExposureOfACamera, BlankImagesAndOtherSizesAreNoJumps) {
  gain(image(0));
  for (const double grey : {0.0, 255.0}) {
    EXPECT_EQ(gain(cv::Mat(240, 320, CV_8UC3, cv::Scalar::all(grey))), 1.0);
  }
  gain(image(1));
  gain(scaled(image(1), 0.5).rowRange(0, 100));
  gain(cv::Mat());
  EXPECT_EQ(gain(image(2)), 1.0);
}

TEST_F(ExposureOfACamera, TrackingGoesOnThroughAJumpOfTheExposure) {
  constexpr double kJump = 0.4;
  TrackerOptions options = tracker_test_options();
  const auto with = track_with_a_jump(options, kJump);
  for (const FrameRecord& record : with) {
    EXPECT_EQ(record.status, TrackingStatus::kTracked) << record.index << ": " << record.reason;
    const SE3 error = frames_.T_first_camera(0, record.index).inverse() * record.T_world_camera;
    EXPECT_LT(error.translation().norm(), 0.005) << record.index;
  }
  options.compensate_exposure = false;
  const auto without = track_with_a_jump(options, kJump);
  EXPECT_EQ(without[3].registration.cos_theta, with[3].registration.cos_theta);
  EXPECT_LT(without[4].registration.cos_theta, 0.5 * with[4].registration.cos_theta);
}

// What the frame-to-frame comparison alone counts wrongly: only the jumps, and all in one
// direction.
TEST_F(ExposureOfACamera, AHundredJumpsUpAndRampsDownLeaveTrackingAsItWas) {
  constexpr std::size_t kPlaces = 10;  // there and back
  constexpr std::size_t kRamp = 12;    // frames from bright to dark
  const double step = std::pow(0.5, 1.0 / kRamp);
  std::vector<RgbdFrame> views;
  for (std::size_t i = 0; i <= kPlaces; ++i) views.push_back(frames_.frame(i));
  TrackerOptions options = tracker_test_options();
  options.keyframe.max_translation = 0.03;  // keyframes during the ramps
  Tracker tracker(frames_.camera(), options);
  double factor = 0.5;
  double cos_theta_first = 0;
  double cos_theta_last = 0;
  for (std::size_t i = 0; i < 100 * kRamp; ++i) {
    const std::size_t phase = i % (2 * kPlaces);
    const std::size_t place = phase <= kPlaces ? phase : 2 * kPlaces - phase;
    RgbdFrame frame = views[place];
    frame.index = i;
    frame.stamp = frame.depth_stamp = Timestamp::from_seconds(static_cast<double>(i) / 30);
    factor = i % kRamp == 0 ? 1.0 : factor * step;
    frame.color = scaled(frame.color, factor);
    const FrameRecord record = tracker.track(frame).record;
    ASSERT_EQ(record.status, TrackingStatus::kTracked) << i << ": " << record.reason;
    const SE3 error = frames_.T_first_camera(0, place).inverse() * record.T_world_camera;
    ASSERT_LT(error.translation().norm(), 0.05) << i;
    if (i > 0 && i < 10 * kRamp)
      cos_theta_first += record.registration.cos_theta / (10 * kRamp - 1);
    if (i >= 90 * kRamp) cos_theta_last += record.registration.cos_theta / (10 * kRamp);
  }
  EXPECT_NEAR(cos_theta_last, cos_theta_first, 0.05 * cos_theta_first);
}

// 1 % a frame is too little to be a jump.
TEST_F(ExposureOfACamera, TheGainFollowsASlowRamp) {
  const RgbdFrame view = frames_.frame(0);
  const Camera camera = frames_.camera();
  const FieldOfView field_of_view(camera.color);
  const PointCloud points = select_points(view, camera, 1000);
  Exposure exposure = exposure_.update(view.color);
  RgbdFrame frame = view;
  double factor = 1;
  for (int i = 0; i < 60; ++i) {
    factor *= 0.99;
    frame.color = scaled(view.color, factor);
    std::ignore = exposure_.update(frame.color);
    const auto log_ratio = log_brightness_ratio(points, frame, view, SE3(), camera, field_of_view);
    ASSERT_TRUE(log_ratio.has_value());
    EXPECT_NEAR(*log_ratio, std::log(factor), 0.03);
    exposure = exposure_.observe({}, *log_ratio);
    EXPECT_LT(std::abs(std::log(exposure.gain / factor)), 0.2) << i;
  }
  EXPECT_LT(exposure.gain, 0.7);
}

}  // namespace
}  // namespace cvo_slam
