// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What is done where the graph does not say where a camera can be: submaps are joined, and lost
// cameras are found.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "cvo_slam/slam/slam.h"
#include "cvo_slam/tests/slam/mapper_walk.h"

namespace cvo_slam {
namespace {

using testing::HasSubstr;

class SubmapsOfAMapper : public MapperWalk {
 protected:
  SubmapsOfAMapper() {
    SlamOptions options = loop_options();
    options.loops.detection.candidates.min_score = 0.7;  // or the other wall is of the same group
    make_mapper(options);
  }

  /// Keyframes along the walk in the world of another submap.
  void walk_again(int first, int end, int submap) {
    for (int i = first; i < end; ++i) add(place(i), T_elsewhere_ * pose(place(i)), submap);
  }
  [[nodiscard]] std::size_t submaps() const {
    const auto components = mapper_->graph().components();
    return 1 + *std::max_element(components.begin(), components.end());
  }
  void expect_pose(std::size_t node, const SE3& expected) const {
    const SE3 error = expected.inverse() * mapper_->graph().nodes()[node].T_world_node;
    EXPECT_LT(error.translation().norm(), 0.008) << node << ": a pixel at 2 m";
    EXPECT_LT(error.angle(), 0.004) << node << ": a pixel";
  }

  /// A walk, then other places, then places that look like the first ones.
  void walk_past_ambiguous_places() {
    walk(5);
    for (int i = 0; i < 4; ++i) add(kElsewhere + place(i), pose(kElsewhere + place(i)));
    for (int i = 0; i < 5; ++i) add(place(i), same_looking(place(i)));
  }
  [[nodiscard]] bool has_reason(const std::string& text) const {
    const auto& candidates = mapper_->candidates();
    return std::any_of(candidates.begin(), candidates.end(), [&](const LoopCandidate& candidate) {
      return candidate.reason.find(text) != std::string::npos;
    });
  }

  static constexpr std::size_t kElsewhere = 150;  // another wall
  SE3 T_elsewhere_ = SE3(so3_exp({0.3, -1, 0.2}), {4, -3, 2});
};

TEST_F(SubmapsOfAMapper, AreJoinedWhereThreeKeyframesAgree) {
  walk(6);
  walk_again(1, 3, 1);
  EXPECT_EQ(submaps(), 2U) << "two are not enough";
  ASSERT_FALSE(loops_of_newest().empty());
  EXPECT_THAT(loops_of_newest()[0].reason, HasSubstr("waits for keyframes that agree"));
  EXPECT_EQ(mapper_->map().submaps.name_of(1), 1);
  walk_again(3, 5, 1);
  EXPECT_EQ(submaps(), 1U);
  EXPECT_EQ(mapper_->map().submaps.name_of(1), 0);
  EXPECT_GE(accepted(loops_of(mapper_->candidates())), 3U);
  for (int i = 1; i < 5; ++i) expect_pose(5 + static_cast<std::size_t>(i), pose(place(i)));
}

TEST_F(SubmapsOfAMapper, OnesThatLookLikeTwoPlacesAreNotJoined) {
  walk_past_ambiguous_places();
  ASSERT_EQ(accepted(loops_of(mapper_->candidates())), 0U);
  walk_again(0, 5, 1);
  EXPECT_EQ(submaps(), 2U);
  EXPECT_TRUE(has_reason("ambiguous place"));
}

// The submap begins at a place that looks like a known one, and goes on to another one.
TEST_F(SubmapsOfAMapper, JoinedAtAnAmbiguousPlaceAreJoinedAgainWhenMoreSaysOtherwise) {
  walk(5);
  for (int i = 0; i < 6; ++i) add(kElsewhere + place(i), pose(kElsewhere + place(i)));
  const std::size_t first = poses_.size();
  for (int i = 0; i < 3; ++i) add(place(i), same_looking(place(i)), 1);
  EXPECT_EQ(submaps(), 1U) << "three agree";
  for (int i = 0; i < 5; ++i) add(kElsewhere + place(i), pose(kElsewhere + place(i)), 1);
  EXPECT_TRUE(has_reason("say that its submap is elsewhere"));
  EXPECT_EQ(submaps(), 1U);
  for (int i = 0; i < 3; ++i)
    expect_pose(first + static_cast<std::size_t>(i), same_looking(place(i)));
}

TEST_F(SubmapsOfAMapper, FarFromWhereTheCameraWasLostALikenessMustBeStrong) {
  SlamOptions options = loop_options();
  options.loops.relocalization.min_agreement = 10;
  make_mapper(options);
  walk(6);
  add(place(1) + 2, T_elsewhere_, 1);
  ASSERT_FALSE(loops_of_newest().empty());
  EXPECT_THAT(loops_of_newest()[0].reason, HasSubstr("so far from where the camera was lost"));
}

TEST_F(SubmapsOfAMapper, NearWhereTheCameraWasLostItNeedNot) {
  SlamOptions options = loop_options();
  options.loops.relocalization.min_agreement = 10;
  options.loops.detection.candidates.min_gap = 0;
  make_mapper(options);
  walk(6);
  add(place(5) - 1, pose(place(5)), 1);  // a frame later and a frame's way off
  ASSERT_FALSE(loops_of_newest().empty());
  EXPECT_THAT(loops_of_newest()[0].reason, HasSubstr("waits for keyframes that agree"));
}

TEST_F(SubmapsOfAMapper, ALostImageIsFound) {
  walk(6);
  const RgbdFrame image = walk_.frame(100, place(2) + 2);
  const auto found = mapper_->relocalize(image, points_of(image));
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->submap, 0);
  const SE3 error = pose(place(2) + 2).inverse() * found->T_world_camera;
  EXPECT_LT(error.translation().norm(), 0.008) << "a pixel at 2 m";
  EXPECT_LT(error.angle(), 0.004) << "a pixel";
  EXPECT_TRUE(mapper_->candidates().back().relocalization);
  EXPECT_FALSE(mapper_->candidates().back().accepted) << "before others agree";
}

TEST_F(SubmapsOfAMapper, ALostImageOfNowhereOrNothingIsNot) {
  walk(6);
  RgbdFrame image = walk_.frame(100, kElsewhere);
  EXPECT_FALSE(mapper_->relocalize(image, points_of(image)).has_value());
  image.color.setTo(0);
  EXPECT_FALSE(mapper_->relocalize(image, points_of(image)).has_value());
}

TEST_F(SubmapsOfAMapper, ALostImageThatLooksLikeTwoPlacesIsNot) {
  walk_past_ambiguous_places();
  const RgbdFrame image = walk_.frame(100, place(2));
  EXPECT_FALSE(mapper_->relocalize(image, points_of(image)).has_value());
  EXPECT_TRUE(has_reason("ambiguous place"));
}

/// A camera walks, is carried to another wall and back, and walks on.
class KidnappedCamera : public testing::Test {
 protected:
  static constexpr std::size_t kCarriedOff = 40;  // the first frame elsewhere
  static constexpr std::size_t kBack = 55;        // the first frame that shows known places again
  static constexpr std::size_t kFrames = 80;
  static constexpr std::size_t kElsewhere = 150;  // another wall

  static std::size_t place(std::size_t index) {
    if (index < kCarriedOff) return index;
    return index < kBack ? kElsewhere + index : index - kBack + 5;
  }

  KidnappedCamera() {
    slam_.tracker.keyframe = {.min_overlap = 0, .max_translation = 0.05, .max_rotation = 0.06};
  }
  static void SetUpTestSuite() {
    const SyntheticFrames walk{small_camera(320, 240)};
    frames_.clear();
    for (std::size_t i = 0; i < kFrames; ++i) frames_.push_back(walk.frame(i, place(i)));
  }
  static void TearDownTestSuite() { frames_.clear(); }

  struct Run {
    std::vector<FrameRecord> records;
    Trajectory trajectory;
    Trajectory online;
    std::vector<LoopCandidate> candidates;
    std::vector<Keyframe> keyframes;
  };
  [[nodiscard]] Run run() const {
    Slam slam(small_camera(320, 240), slam_);
    Run run;
    for (const RgbdFrame& frame : frames_) run.records.push_back(slam.track(frame));
    slam.finish();
    run.trajectory = slam.trajectory();
    run.online = slam.trajectory(TrajectoryView::kOnline);
    run.candidates = slam.loop_candidates();
    run.keyframes = slam.keyframes();
    return run;
  }
  static void expect_near_truth(std::size_t index, const SE3& T_world_camera) {
    const SyntheticFrames walk{small_camera(320, 240)};
    const SE3 error = walk.T_first_camera(0, place(index)).inverse() * T_world_camera;
    EXPECT_LT(error.translation().norm(), 0.016) << index << ": two pixels at 2 m";
    EXPECT_LT(error.angle(), 0.008) << index << ": two pixels";
  }

  static inline std::vector<RgbdFrame> frames_;
  SlamOptions slam_ = loop_options();
};

TEST_F(KidnappedCamera, IsFoundWithinTenFrames) {
  const Run result = run();
  std::size_t found = kBack;
  while (found < kFrames && (result.records[found].status == TrackingStatus::kLost ||
                             result.records[found].submap != 0)) {
    ++found;
  }
  EXPECT_LT(found, kBack + 10);
  for (std::size_t i = found; i < kFrames; ++i) {
    ASSERT_EQ(result.records[i].status, TrackingStatus::kTracked) << i;
    EXPECT_EQ(result.records[i].submap, 0) << i;
    expect_near_truth(i, result.records[i].T_world_camera);
  }
}

TEST_F(KidnappedCamera, IsNotFoundWhereItHasNotBeen) {
  const Run result = run();
  for (std::size_t i = kCarriedOff; i < kBack; ++i) {
    const FrameRecord& record = result.records[i];
    EXPECT_TRUE(record.status == TrackingStatus::kLost || record.submap != 0) << i;
  }
}

TEST_F(KidnappedCamera, HasOnePathAndLostFramesStayLost) {
  const Run result = run();
  EXPECT_EQ(result.trajectory.poses.size() + result.trajectory.lost.size(), kFrames);
  EXPECT_GT(result.trajectory.poses.size(), kCarriedOff + (kFrames - kBack) - 10);
  for (const StampedPose& pose : result.trajectory.poses) {
    const auto record = std::find_if(result.records.begin(), result.records.end(),
                                     [&](const FrameRecord& r) { return r.stamp == pose.stamp; });
    ASSERT_EQ(record->status, TrackingStatus::kTracked);
    expect_near_truth(record->index, pose.T_world_camera);
  }
  EXPECT_EQ(result.online.poses.size(), result.trajectory.poses.size());
}

TEST_F(KidnappedCamera, GivesTheSameAgainWithTwoThreadsAndPipelined) {
  const Run first = run();
  const auto expect_equal = [&first](const Run& other) {
    ASSERT_EQ(first.records.size(), other.records.size());
    for (std::size_t i = 0; i < first.records.size(); ++i) {
      EXPECT_EQ(first.records[i].status, other.records[i].status) << i;
      EXPECT_EQ(first.records[i].T_world_camera.matrix(), other.records[i].T_world_camera.matrix());
    }
    ASSERT_EQ(first.trajectory.poses.size(), other.trajectory.poses.size());
    for (std::size_t i = 0; i < first.trajectory.poses.size(); ++i) {
      EXPECT_EQ(first.trajectory.poses[i].T_world_camera.matrix(),
                other.trajectory.poses[i].T_world_camera.matrix());
    }
    ASSERT_EQ(first.candidates.size(), other.candidates.size());
    for (std::size_t i = 0; i < first.candidates.size(); ++i) {
      EXPECT_EQ(first.candidates[i].reason, other.candidates[i].reason);
    }
  };
  slam_.tracker.threads = 2;
  slam_.schedule = Schedule::kPipelined;
  expect_equal(run());
}

/// A camera walks, stands for two seconds, and walks on.
class BlindedCamera : public testing::Test {
 protected:
  static constexpr std::size_t kStop = 20;
  static constexpr std::size_t kOn = kStop + 60;
  static constexpr std::size_t kFrames = kOn + 20;

  static std::size_t place(std::size_t index) {
    if (index < kStop) return index;
    return index < kOn ? kStop : index - kOn + kStop + 1;
  }
  static void SetUpTestSuite() {
    const SyntheticFrames walk{small_camera(320, 240)};
    frames_.clear();
    for (std::size_t i = 0; i < kFrames; ++i) {
      if (i <= kStop || i >= kOn) {
        frames_.push_back(walk.frame(i, place(i)));
        continue;
      }
      RgbdFrame frame = frames_[kStop];
      frame.index = i;
      frame.stamp = frame.depth_stamp = Timestamp::from_seconds(100 + static_cast<double>(i) / 30);
      frames_.push_back(frame);
    }
  }
  static void TearDownTestSuite() { frames_.clear(); }

  enum class Blind { kNot, kWhite, kBlack, kBlurred };
  static RgbdFrame spoiled(const RgbdFrame& original, Blind blind) {
    RgbdFrame frame = original;
    if (blind == Blind::kBlurred) {
      constexpr double kWidth = 20;  // [px]; nothing has a gradient any more
      cv::GaussianBlur(original.color, frame.color, {}, kWidth);
      return frame;
    }
    frame.color = original.color.clone();
    frame.color.setTo(cv::Scalar::all(blind == Blind::kWhite ? 255 : 0));
    frame.depth = cv::Mat::zeros(original.depth.size(), CV_16U);
    return frame;
  }
  static Trajectory run(Blind blind) {
    Slam slam(small_camera(320, 240), loop_options());
    for (std::size_t i = 0; i < kFrames; ++i) {
      const bool is_blind = blind != Blind::kNot && i >= kStop && i < kOn;
      slam.track(is_blind ? spoiled(frames_[i], blind) : frames_[i]);
    }
    slam.finish();
    return slam.trajectory();
  }
  /// Root of the mean squared distance from the true positions [m].
  static double error(const Trajectory& trajectory) {
    const SyntheticFrames walk{small_camera(320, 240)};
    double sum = 0;
    for (const StampedPose& pose : trajectory.poses) {
      const auto frame = std::find_if(frames_.begin(), frames_.end(),
                                      [&](const RgbdFrame& f) { return f.stamp == pose.stamp; });
      const SE3 T_true = walk.T_first_camera(0, place(frame->index));
      sum += (pose.T_world_camera.translation() - T_true.translation()).squaredNorm();
    }
    return std::sqrt(sum / static_cast<double>(trajectory.poses.size()));
  }

  static inline std::vector<RgbdFrame> frames_;
};

TEST_F(BlindedCamera, GoesOnAndIsNotMuchWorse) {
  const double undisturbed = error(run(Blind::kNot));
  for (const Blind blind : {Blind::kWhite, Blind::kBlack, Blind::kBlurred}) {
    const Trajectory trajectory = run(blind);
    EXPECT_EQ(trajectory.lost.size(), kOn - kStop) << "the blind frames and no others";
    EXPECT_EQ(trajectory.poses.size(), kFrames - (kOn - kStop));
    // As the issue asks; a tenth of a pixel at 2 m, 0.8 mm, is what noise may do.
    EXPECT_LT(error(trajectory), 1.5 * undisturbed + 0.0008);
  }
}

}  // namespace
}  // namespace cvo_slam
