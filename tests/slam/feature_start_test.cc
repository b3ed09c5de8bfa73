// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <opencv2/core/mat.hpp>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/saved_state.h"
#include "cvo_slam/loop/loop_detector.h"
#include "cvo_slam/slam/feature_start_internal.h"
#include "cvo_slam/tests/frontend/synthetic_frames.h"
#include "cvo_slam/tests/frontend/test_frames.h"

namespace cvo_slam {
namespace {

/// A walk of which keyframe 8 shows nothing.
class FeatureStartOfAWalk : public testing::Test {
 protected:
  static constexpr std::size_t kBlank = 8;
  static constexpr std::size_t kFrame = 12;

  RgbdFrame blank() const {
    RgbdFrame frame = frames_.frame(kBlank);
    frame.color = cv::Mat(frame.color.size(), frame.color.type(), cv::Scalar::all(128));
    return frame;
  }
  std::optional<SE3> find(FeatureStart& start) {
    return start.find(blank(), frames_.T_world_camera(kBlank), frames_.frame(kFrame));
  }
  void expect_found(const std::optional<SE3>& T_keyframe_camera) {
    ASSERT_TRUE(T_keyframe_camera);
    const SE3 error = frames_.T_first_camera(kBlank, kFrame).inverse() * *T_keyframe_camera;
    EXPECT_LT(error.translation().norm(), 0.02);
    EXPECT_LT(error.angle(), 0.02);
  }

  SyntheticFrames frames_{small_camera(320, 240)};
  LoopOptions options_;
  LoopDetector detector_{frames_.camera(), options_};
  AppearanceCache appearances_{detector_};
  FeatureStart start_{frames_.camera(), options_.verification, appearances_};
};

TEST_F(FeatureStartOfAWalk, TheKeyframesBeforeHelpWhereTheKeyframeShowsNothing) {
  EXPECT_FALSE(find(start_));
  start_.add(frames_.frame(4), frames_.T_world_camera(4));
  start_.add(blank(), frames_.T_world_camera(kBlank));
  expect_found(find(start_));
  start_.clear();
  EXPECT_FALSE(find(start_)) << "they are of another world";
}

TEST_F(FeatureStartOfAWalk, AreSavedWithASession) {
  start_.add(frames_.frame(4), frames_.T_world_camera(4));
  SavedState saved;
  saved(start_);
  FeatureStart other(frames_.camera(), options_.verification, appearances_);
  SavedState read(saved.bytes());
  read(other);
  read.expect_end();
  expect_found(find(other));
  FeatureStart of_another_camera(small_camera(160, 120), options_.verification, appearances_);
  SavedState again(saved.bytes());
  EXPECT_THROW(again(of_another_camera), DataError);
}

}  // namespace
}  // namespace cvo_slam
