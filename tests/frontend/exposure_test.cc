// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstddef>
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

class Exposure : public testing::Test {
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

  SyntheticFrames frames_{small_camera(320, 240)};
  ExposureGain exposure_;
};

TEST_F(Exposure, GainIsExactlyOneIfOnlyTheViewChanges) {
  for (std::size_t i = 0; i < 20; ++i) EXPECT_EQ(exposure_.update(image(i)), 1.0);
  EXPECT_EQ(exposure_.update(image(150)), 1.0) << "the other side of the room";
}

TEST_F(Exposure, GainFollowsJumpsThatAddUpAndEnd) {
  exposure_.update(image(0));
  EXPECT_NEAR(exposure_.update(scaled(image(1), 0.5)), 0.5, 0.02);
  EXPECT_NEAR(exposure_.update(scaled(image(2), 0.5)), 0.5, 0.02);
  EXPECT_NEAR(exposure_.update(scaled(image(3), 0.3)), 0.3, 0.02);
  EXPECT_NEAR(exposure_.update(image(4)), 1, 0.03);
}

TEST_F(Exposure, GainIsTheSameForGreyAndColouredImages) {
  double gain = 1;
  for (const double factor : {1.0, 0.6}) {
    cv::Mat one_channel;
    cv::extractChannel(scaled(image(0), factor), one_channel, 1);
    gain = exposure_.update(one_channel);
  }
  EXPECT_NEAR(gain, 0.6, 0.02);
}

TEST_F(Exposure, BlankImagesAndOtherSizesAreNoJumps) {
  exposure_.update(image(0));
  for (const double grey : {0.0, 255.0}) {
    EXPECT_EQ(exposure_.update(cv::Mat(240, 320, CV_8UC3, cv::Scalar::all(grey))), 1.0);
  }
  exposure_.update(image(1));
  exposure_.update(scaled(image(1), 0.5).rowRange(0, 100));
  exposure_.update(cv::Mat());
  EXPECT_EQ(exposure_.update(image(2)), 1.0);
}

TEST_F(Exposure, TrackingGoesOnThroughAJumpOfTheExposure) {
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

}  // namespace
}  // namespace cvo_slam
