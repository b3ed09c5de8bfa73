// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The façade on exact images of a walk that comes back.
#include "cvo_slam/slam/slam.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <stdexcept>
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

/// There and back again.
constexpr std::size_t kTurn = 20;
constexpr std::size_t kFrames = 2 * kTurn + 1;

std::size_t place(std::size_t index) { return index <= kTurn ? index : 2 * kTurn - index; }

class SlamOnSyntheticFrames : public testing::Test {
 protected:
  SlamOnSyntheticFrames() {
    slam_.tracker = tracker_test_options();
    slam_.loops.enabled = false;
    // Keyframes so near to one another that this short walk makes a graph of them.
    slam_.tracker.keyframe = {.min_overlap = 0, .max_translation = 0.05, .max_rotation = 0.06};
    slam_.proximity.min_gap = 2;
    slam_.optimize_every = 3;
  }

  static void SetUpTestSuite() {
    const SyntheticFrames walk{small_camera(320, 240)};
    frames_.clear();
    for (std::size_t i = 0; i < kFrames; ++i) frames_.push_back(walk.frame(i, place(i)));
  }
  static void TearDownTestSuite() { frames_.clear(); }

  [[nodiscard]] Slam make_slam() const { return Slam(small_camera(320, 240), slam_); }

  static void track(Slam& slam, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) slam.track(frames_[i]);
  }

  [[nodiscard]] Slam run() const {
    Slam slam = make_slam();
    track(slam, 0, kFrames);
    slam.finish();
    return slam;
  }

  /// Root of the mean squared distance between the positions and the true ones [m]; the first
  /// camera is the origin of both.
  static double error(const Trajectory& trajectory) {
    const SyntheticFrames walk{small_camera(320, 240)};
    double sum = 0;
    for (std::size_t i = 0; i < trajectory.poses.size(); ++i) {
      const SE3 T_true = walk.T_first_camera(0, place(i));
      sum +=
          (trajectory.poses[i].T_world_camera.translation() - T_true.translation()).squaredNorm();
    }
    return std::sqrt(sum / static_cast<double>(trajectory.poses.size()));
  }

  static void expect_same(const Trajectory& a, const Trajectory& b) {
    ASSERT_EQ(a.poses.size(), b.poses.size());
    for (std::size_t i = 0; i < a.poses.size(); ++i) {
      EXPECT_EQ(a.poses[i].T_world_camera.matrix(), b.poses[i].T_world_camera.matrix()) << i;
    }
  }

  static inline std::vector<RgbdFrame> frames_;
  SlamOptions slam_;
};

TEST_F(SlamOnSyntheticFrames, TheGraphIsNotWorseThanOdometry) {
  const Slam slam = run();
  slam_.proximity.recent = slam_.proximity.near = 0;
  const double odometry = error(run().trajectory());
  // A tenth of a pixel at 2 m, 0.8 mm, is what noise may do where odometry has not drifted.
  EXPECT_LT(error(slam.trajectory()), odometry + 0.0008);
  EXPECT_LT(error(slam.trajectory()), 0.008) << "a pixel at 2 m";
}

TEST_F(SlamOnSyntheticFrames, TheWayBackIsConnectedToTheWayThere) {
  const Slam slam = run();
  const PoseGraph graph = slam.pose_graph();
  EXPECT_EQ(graph.nodes().size(), slam.keyframes().size());
  std::size_t longest = 0;
  for (const PoseGraphEdge& edge : graph.edges()) {
    EXPECT_EQ(edge.robust, edge.kind == EdgeKind::kProximity);
    longest = std::max(longest, static_cast<std::size_t>(edge.to - edge.from));
  }
  EXPECT_GT(longest, kTurn);
}

TEST_F(SlamOnSyntheticFrames, EveryCandidateHasAVerdictAndTheAcceptedOnesAreEdges) {
  const Slam slam = run();
  std::size_t accepted = 0;
  for (const LoopCandidate& candidate : slam.loop_candidates()) {
    EXPECT_EQ(candidate.accepted, candidate.reason.empty());
    EXPECT_LT(candidate.from, candidate.to);
    if (candidate.accepted) ++accepted;
  }
  const PoseGraph graph = slam.pose_graph();
  EXPECT_GT(accepted, 0U);
  EXPECT_EQ(graph.edges().size(), graph.nodes().size() - 1 + accepted);
}

TEST_F(SlamOnSyntheticFrames, WhatIsNotBelievedSaysWhy) {
  const auto reason_with = [this](const std::function<void(ProximityOptions&)>& change) {
    slam_.proximity = {};
    slam_.proximity.min_gap = 2;
    change(slam_.proximity);
    std::string reasons;
    for (const LoopCandidate& candidate : run().loop_candidates()) reasons += candidate.reason;
    return reasons;
  };
  using testing::HasSubstr;
  EXPECT_THAT(reason_with([](auto& o) { o.pair.min_overlap = 1; }), HasSubstr("overlap"));
  EXPECT_THAT(reason_with([](auto& o) {
                o.pair.min_overlap = 0;
                o.pair.min_cos_theta = 1;
              }),
              HasSubstr("cos_theta"));
  EXPECT_THAT(reason_with([](auto& o) { o.pair.max_round_trip_rotation = 0; }),
              HasSubstr("and back"));
  EXPECT_THAT(reason_with([](auto& o) { o.pair.max_error = 0; }), HasSubstr("standard deviations"));
}

TEST_F(SlamOnSyntheticFrames, SameResultAgainWithTwoThreadsAndPipelined) {
  const Slam first = run();
  const auto expect_equal = [&first](const Slam& other) {
    expect_same(first.trajectory(), other.trajectory());
    expect_same(first.trajectory(TrajectoryView::kOnline),
                other.trajectory(TrajectoryView::kOnline));
    EXPECT_EQ(first.loop_candidates().size(), other.loop_candidates().size());
  };
  expect_equal(run());
  slam_.tracker.threads = 2;
  expect_equal(run());
  slam_.schedule = Schedule::kPipelined;
  expect_equal(run());
}

TEST_F(SlamOnSyntheticFrames, EveryFrameHasAPose) {
  const Slam slam = run();
  EXPECT_EQ(slam.trajectory().poses.size(), kFrames);
  EXPECT_EQ(slam.trajectory(TrajectoryView::kOnline).poses.size(), kFrames);
  EXPECT_TRUE(slam.trajectory().lost.empty());
}

// A step at each keyframe would be what the graph has corrected since the one before.
TEST_F(SlamOnSyntheticFrames, FramesBetweenTwoKeyframesShareTheirCorrection) {
  Slam slam = make_slam();
  std::vector<FrameRecord> records;
  records.reserve(frames_.size());
  for (const RgbdFrame& frame : frames_) records.push_back(slam.track(frame));
  slam.finish();
  const auto final_pose = [poses = slam.trajectory().poses](std::size_t i) {
    return poses[i].T_world_camera;
  };
  const auto correction = [&](std::size_t keyframe, std::size_t i) -> Vector6 {
    const SE3 T_world_tracked = final_pose(keyframe) * records[i].registration.T_fixed_moving;
    return (T_world_tracked.inverse() * final_pose(i)).log();
  };
  double largest = 0;
  for (const Keyframe& next : slam.keyframes()) {
    const std::size_t keyframe = records[next.number].keyframe;
    const Vector6 whole = correction(keyframe, next.number);
    for (std::size_t i = keyframe + 1; i < next.number; ++i) {
      const double share =
          static_cast<double>(i - keyframe) /
          static_cast<double>(next.number - keyframe);  // of the time, at a fixed rate
      EXPECT_LT((correction(keyframe, i) - share * whole).norm(), 1e-9) << i;
      largest = std::max(largest, share * whole.norm());
    }
  }
  EXPECT_GT(largest, 1e-5);  // there was something to share
}

TEST_F(SlamOnSyntheticFrames, FinishMayBeCalledAgainAndTrackingMayGoOn) {
  for (const Schedule schedule : {Schedule::kInline, Schedule::kPipelined}) {
    slam_.schedule = schedule;
    Slam slam = make_slam();
    track(slam, 0, kTurn);
    slam.finish();
    const Trajectory half = slam.trajectory();
    slam.finish();
    expect_same(slam.trajectory(), half);
    EXPECT_EQ(slam.statistics().full_solves, 1);
    track(slam, kTurn, kFrames);
    EXPECT_EQ(slam.trajectory().poses.size(), kFrames) << "before the map has all keyframes";
    slam.finish();
    EXPECT_EQ(slam.statistics().full_solves, 2);
    EXPECT_GT(slam.statistics().keyframe_bytes, 10'000 * slam.keyframes().size());
    EXPECT_LT(error(slam.trajectory()), 0.008) << "a pixel at 2 m";
  }
}

TEST_F(SlamOnSyntheticFrames, LostFramesStayLost) {
  Slam slam = make_slam();
  track(slam, 0, 8);
  RgbdFrame dark = frames_[8];
  dark.depth = cv::Mat::zeros(240, 320, CV_16U);
  EXPECT_EQ(slam.track(dark).status, TrackingStatus::kLost);
  track(slam, 9, 16);
  slam.finish();
  EXPECT_EQ(slam.trajectory().poses.size(), 15U);
  ASSERT_EQ(slam.trajectory().lost.size(), 1U);
  EXPECT_THAT(slam.trajectory().lost[0].reason, testing::HasSubstr("0 points"));
}

TEST_F(SlamOnSyntheticFrames, SubmapsAreNotConnected) {
  slam_.tracker.lost.restart_time = 0;
  const SyntheticFrames walk{small_camera(320, 240)};
  constexpr std::size_t kElsewhere = 150;  // another wall
  Slam slam = make_slam();
  track(slam, 0, 10);
  for (std::size_t i = 10; i < 20; ++i) slam.track(walk.frame(i, kElsewhere + i));
  slam.finish();
  EXPECT_EQ(slam.keyframes().front().submap, 0);
  EXPECT_EQ(slam.keyframes().back().submap, 1);
  const auto components = slam.pose_graph().components();
  EXPECT_EQ(components.back(), 1U);
  const Trajectory trajectory = slam.trajectory();
  EXPECT_EQ(trajectory.poses.size() + trajectory.lost.size(), 20U);
  EXPECT_THAT(trajectory.lost.back().reason, testing::Not(testing::IsEmpty()));
}

TEST_F(SlamOnSyntheticFrames, OfNothingIsEmpty) {
  Slam slam = make_slam();
  slam.finish();
  EXPECT_TRUE(slam.trajectory().poses.empty());
  EXPECT_TRUE(slam.keyframes().empty());
  EXPECT_TRUE(slam.pose_graph().nodes().empty());
  EXPECT_TRUE(slam.loop_candidates().empty());
}

TEST_F(SlamOnSyntheticFrames, IndicesMustAscend) {
  Slam slam = make_slam();
  track(slam, 0, 2);
  EXPECT_THROW(slam.track(frames_[1]), DataError);
}

TEST_F(SlamOnSyntheticFrames, AnObjectThatWasMovedFromSaysSo) {
  Slam slam = make_slam();
  const Slam other = std::move(slam);
  // NOLINTBEGIN(bugprone-use-after-move,clang-analyzer-cplusplus.Move)
  EXPECT_THROW(slam.track(frames_[0]), UsageError);
  EXPECT_THROW(slam.finish(), UsageError);
  EXPECT_THROW(std::ignore = slam.trajectory(), UsageError);
  // NOLINTEND(bugprone-use-after-move,clang-analyzer-cplusplus.Move)
  EXPECT_TRUE(other.keyframes().empty());
}

TEST_F(SlamOnSyntheticFrames, TakesTheDepthImageThatIsNearestAfterTheOffset) {
  Camera camera = small_camera(320, 240);
  const auto depth_at = [](const RgbdFrame& frame, std::int64_t milliseconds) {
    return DepthImage{frame.depth, Timestamp(frame.stamp.nanoseconds() + milliseconds * 1'000'000)};
  };
  RgbdFrame color = frames_[0];
  color.depth.release();
  const DepthImage before = depth_at(frames_[0], -5);
  const DepthImage after{cv::Mat::zeros(240, 320, CV_16UC1), depth_at(frames_[0], 12).stamp};
  for (const auto& [offset, is_before] : {std::pair(0.0, true), std::pair(-0.01, false)}) {
    camera.depth_offset = offset;
    Slam slam(camera, slam_);
    // The second image is empty.
    EXPECT_EQ(slam.track(color, {after, before}).status == TrackingStatus::kTracked, is_before);
  }
  EXPECT_THROW(make_slam().track(color, {}), DataError);
}

TEST_F(SlamOnSyntheticFrames, AnObserverSeesEveryFrameAndEveryKeyframeThatMoves) {
  const auto observed = [this](Schedule schedule) {
    slam_.schedule = schedule;
    Slam slam = make_slam();
    std::vector<FrameRecord> records;
    std::vector<std::vector<Keyframe>> corrections;
    slam.observe({[&](const FrameRecord& record) { records.push_back(record); },
                  [&](const std::vector<Keyframe>& moved) { corrections.push_back(moved); }});
    for (std::size_t i = 0; i < kFrames; ++i) {
      const FrameRecord record = slam.track(frames_[i]);
      EXPECT_EQ(records.size(), i + 1);
      EXPECT_EQ(records.back().T_world_camera.matrix(), record.T_world_camera.matrix());
    }
    EXPECT_GT(corrections.size(), 2U);
    slam.finish();
    // Who keeps what was said last has the map's poses.
    std::map<std::size_t, SE3> poses;
    for (const auto& moved : corrections) {
      for (const Keyframe& keyframe : moved) poses[keyframe.number] = keyframe.T_world_camera;
    }
    EXPECT_EQ(poses.size(), slam.keyframes().size());
    for (const Keyframe& keyframe : slam.keyframes()) {
      EXPECT_EQ(poses[keyframe.number].matrix(), keyframe.T_world_camera.matrix());
    }
    return corrections.size();
  };
  EXPECT_EQ(observed(Schedule::kInline), observed(Schedule::kPipelined));
}

TEST_F(SlamOnSyntheticFrames, AnObserverThatThrowsChangesNoResult) {
  const Slam undisturbed = run();
  Slam slam = make_slam();
  slam.observe({[](const FrameRecord&) { throw std::runtime_error("of the frame"); },
                [](const std::vector<Keyframe>&) { throw std::runtime_error("of a correction"); }});
  std::set<std::string> thrown;
  const auto catching = [&](const std::function<void()>& call) {
    try {
      call();
    } catch (const std::runtime_error& error) {
      thrown.insert(error.what());
    }
  };
  for (const RgbdFrame& frame : frames_) {
    catching([&] { slam.track(frame); });
  }
  catching([&] { slam.finish(); });
  EXPECT_THAT(thrown, testing::UnorderedElementsAre("of the frame", "of a correction"));
  expect_same(slam.trajectory(), undisturbed.trajectory());
}

TEST_F(SlamOnSyntheticFrames, AnObserverMustNotCallTheObject) {
  Slam slam = make_slam();
  slam.observe({.frame = [&](const FrameRecord&) { std::ignore = slam.keyframes(); }});
  EXPECT_THROW(slam.track(frames_[0]), UsageError);
  slam.observe({});
  EXPECT_NO_THROW(slam.track(frames_[1]));
}

TEST_F(SlamOnSyntheticFrames, ImpossibleOptionsAreErrors) {
  slam_.optimize_every = 0;
  EXPECT_THROW(std::ignore = make_slam(), OptionError);
}

}  // namespace
}  // namespace cvo_slam
