// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A lost camera whose exposure has jumped. Relocalisation once selected its points from the images
// alone, with colours 2.4 times as bright as those of the keyframes: every known place was refused.
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "cvo_slam/slam/slam.h"
#include "cvo_slam/tests/slam/mapper_walk.h"

namespace cvo_slam {
namespace {

constexpr double kJump = 2.4;

/// A camera walks, is carried to another wall, where the exposure jumps, and back, and walks on.
class LostWithAnotherExposure : public testing::Test {
 protected:
  static constexpr std::size_t kCarriedOff = 40;  // the first frame elsewhere
  static constexpr std::size_t kBrighter = 46;    // the first frame of the longer exposure
  static constexpr std::size_t kBack = 55;        // the first frame that shows known places again
  static constexpr std::size_t kFrames = 65;
  static constexpr std::size_t kElsewhere = 150;  // another wall

  static std::size_t place(std::size_t index) {
    if (index < kCarriedOff) return index;
    return index < kBack ? kElsewhere + index : index - kBack + 5;
  }
  /// The images before the jump are darkened, because brighter ones would be cut off at 255.
  static RgbdFrame frame(const SyntheticFrames& walk, std::size_t index) {
    RgbdFrame frame = walk.frame(index, place(index));
    if (index < kBrighter) frame.color.convertTo(frame.color, -1, 1 / kJump);
    return frame;
  }

  static std::vector<FrameRecord> run(bool compensate_exposure) {
    SlamOptions options = loop_options();
    options.tracker.keyframe = {.min_overlap = 0, .max_translation = 0.05, .max_rotation = 0.06};
    options.tracker.compensate_exposure = compensate_exposure;
    // cos_theta is 0.71 with the gain and 0.28 without it, where 0.7 is usual.
    options.loops.pair.min_cos_theta = 0.6;
    const SyntheticFrames walk{small_camera(320, 240)};
    Slam slam(walk.camera(), options);
    std::vector<FrameRecord> records;
    for (std::size_t i = 0; i < kFrames; ++i) records.push_back(slam.track(frame(walk, i)));
    return records;
  }

  /// Returns the first frame after the way back that has a pose in the first submap; kFrames if
  /// there is none.
  static std::size_t first_found(const std::vector<FrameRecord>& records) {
    std::size_t i = kBack;
    while (i < kFrames && (records[i].status == TrackingStatus::kLost || records[i].submap != 0)) {
      ++i;
    }
    return i;
  }
};

TEST_F(LostWithAnotherExposure, IsFoundAtAKnownPlace) {
  const std::vector<FrameRecord> records = run(true);
  const std::size_t found = first_found(records);
  ASSERT_LT(found, kFrames);
  const SyntheticFrames walk{small_camera(320, 240)};
  for (std::size_t i = found; i < kFrames; ++i) {
    ASSERT_EQ(records[i].status, TrackingStatus::kTracked) << i;
    const SE3 error = walk.T_first_camera(0, place(i)).inverse() * records[i].T_world_camera;
    EXPECT_LT(error.translation().norm(), 0.016) << i << ": two pixels at 2 m";
    EXPECT_LT(error.angle(), 0.008) << i << ": two pixels";
  }
}

TEST_F(LostWithAnotherExposure, IsNotFoundWithoutTheExposuresGain) {
  EXPECT_EQ(first_found(run(false)), kFrames) << "the test above proves nothing";
}

}  // namespace
}  // namespace cvo_slam
