// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Maps that outlive the Slam that made them: on exact images of a walk.
#include <cstddef>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/io/map_files.h"
#include "cvo_slam/slam/slam.h"
#include "cvo_slam/tests/slam/mapper_walk.h"
#include "cvo_slam/tests/temporary_folder.h"

namespace cvo_slam {
namespace {

constexpr std::size_t kWalk = 40;

class MapsOfSlam : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const SyntheticFrames walk{small_camera(320, 240)};
    frames_.clear();
    poses_.clear();
    for (std::size_t i = 0; i < kWalk; ++i) {
      frames_.push_back(walk.frame(i, i));
      poses_.push_back(walk.T_first_camera(0, i));
    }
  }
  static void TearDownTestSuite() { frames_.clear(); }

  static SlamOptions options() {
    SlamOptions options = loop_options();
    options.tracker.keyframe = {.min_overlap = 0, .max_translation = 0.05, .max_rotation = 0.06};
    return options;
  }

  /// The frames of places, numbered from 0.
  static std::vector<FrameRecord> track(Slam& slam, std::size_t begin, std::size_t end) {
    std::vector<FrameRecord> records;
    for (std::size_t i = begin; i < end; ++i) {
      RgbdFrame frame = frames_[i];
      frame.index = i - begin;
      records.push_back(slam.track(frame));
    }
    return records;
  }

  /// A map of the walk, in the world of its first frame.
  static Map make_map() {
    Slam slam(small_camera(320, 240), options());
    track(slam, 0, kWalk);
    slam.finish();
    return slam.map();
  }

  static void expect_pose(const SE3& estimate, std::size_t place) {
    const SE3 error = poses_[place].inverse() * estimate;
    EXPECT_LT(error.translation().norm(), 0.01) << place;
    EXPECT_LT(error.angle(), 0.006) << place;
  }

  static inline std::vector<RgbdFrame> frames_;
  static inline std::vector<SE3> poses_;
};

TEST_F(MapsOfSlam, SavedLoadedAndSavedTheyAreTheSame) {
  const TemporaryFolder folder;
  const Map map = make_map();
  ASSERT_TRUE(map.memory);
  ASSERT_GT(map.memory->keyframes.size(), 5U);
  write_map(folder.path() / "a", map);
  write_map(folder.path() / "b", Slam(read_map(folder.path() / "a"), options()).map());
  for (const char* name :
       {"map.yaml", "graph.g2o", "edges.txt", "keyframes.csv", "keyframes.bin"}) {
    EXPECT_EQ(read_text(folder.path() / "a" / name), read_text(folder.path() / "b" / name)) << name;
  }
}

// A recorder that is switched off for the night, or a program that saves what it has now and then.
TEST_F(MapsOfSlam, ASessionGoesOnBitForBit) {
  SlamOptions slam_options = options();
  slam_options.correction_delay = 1;
  slam_options.culling.max_memory = 2.5;  // so that some go
  slam_options.tracker.lost = {.restart_time = 0.05, .restart_frames = 2};
  // There and back, blinded in between, so that there are gaps, submaps and loops.
  std::vector<RgbdFrame> walk;
  for (std::size_t i = 0; i < 2 * kWalk; ++i) {
    RgbdFrame frame = frames_[i < kWalk ? i : 2 * kWalk - 1 - i];
    frame.index = i;
    frame.stamp = Timestamp(static_cast<std::int64_t>(i) * 33'333'333);  // more digits than it says
    frame.depth_stamp = frame.stamp;
    // Not by an expression, which would write into the memory that the copies share.
    if (i >= 50 && i < 58) frame.depth = cv::Mat(frame.depth.size(), CV_16UC1, cv::Scalar(0));
    walk.push_back(frame);
  }
  const auto end_of = [](Slam& slam) {
    slam.finish();
    const TemporaryFolder folder;
    write_map(folder.path() / "map", slam.map(MapContent::kSession));
    std::string bytes;
    for (const char* name : {"graph.g2o", "edges.txt", "keyframes.bin", "session.bin"}) {
      bytes += read_text(folder.path() / "map" / name);
    }
    return bytes;
  };
  Slam uninterrupted(small_camera(320, 240), slam_options);
  for (const RgbdFrame& frame : walk) uninterrupted.track(frame);
  const std::string expected = end_of(uninterrupted);
  EXPECT_FALSE(uninterrupted.trajectory().lost.empty());
  EXPECT_FALSE(uninterrupted.loop_candidates().empty());
  EXPECT_GT(uninterrupted.statistics().dropped_keyframes, 0U);
  for (const Schedule schedule : {Schedule::kInline, Schedule::kPipelined}) {
    slam_options.schedule = schedule;
    const TemporaryFolder folder;
    std::optional<Slam> slam(std::in_place, small_camera(320, 240), slam_options);
    slam.emplace(slam->map(MapContent::kSession), slam_options, MapUse::kResume);
    for (const RgbdFrame& frame : walk) {
      slam->track(frame);
      if (frame.index > 1 && frame.index % 13 != 1 && frame.index != 54) continue;
      write_map(folder.path() / "map", slam->map(MapContent::kSession));
      const Map map = read_map(folder.path() / "map");
      slam.emplace(map, slam_options, MapUse::kResume);
      EXPECT_EQ(slam->next_index(), frame.index + 1);
      EXPECT_EQ(slam->map(MapContent::kSession).memory->session, map.memory->session);
    }
    EXPECT_TRUE(end_of(*slam) == expected) << "schedule " << static_cast<int>(schedule);
  }
}

TEST_F(MapsOfSlam, ASessionNeedsTheOptionsAndTheMapThatItHad) {
  Slam slam(small_camera(320, 240), options());
  track(slam, 0, 12);
  const Map map = slam.map(MapContent::kSession);
  EXPECT_THROW(Slam(slam.map(), options(), MapUse::kResume), DataError) << "without a session";
  SlamOptions without_loops = options();
  without_loops.loops.enabled = false;
  EXPECT_THROW(Slam(map, without_loops, MapUse::kResume), DataError);
  Map other = map;
  other.memory->keyframes.pop_back();
  EXPECT_THROW(Slam(other, options(), MapUse::kResume), DataError);
  for (const std::size_t size : {std::size_t{0}, std::size_t{3}, map.memory->session.size() / 2,
                                 map.memory->session.size() - 1}) {
    Map cut = map;
    cut.memory->session.resize(size);
    EXPECT_THROW(Slam(cut, options(), MapUse::kResume), DataError) << size;
  }
  Map longer = map;
  longer.memory->session += 'x';
  EXPECT_THROW(Slam(longer, options(), MapUse::kResume), DataError);
  EXPECT_NO_THROW(Slam(map, options(), MapUse::kExtend)) << "another recording goes on, too";
}

TEST_F(MapsOfSlam, ASecondSessionJoinsThem) {
  const Map map = make_map();
  Slam slam(map, options());
  const auto records = track(slam, 0, kWalk);
  slam.finish();
  EXPECT_EQ(records[3].index, 3U);
  EXPECT_LE(records[30].keyframe, 30U);
  const Trajectory trajectory = slam.trajectory();
  ASSERT_EQ(trajectory.poses.size(), kWalk);
  for (std::size_t i = 0; i < kWalk; ++i) expect_pose(trajectory.poses[i].T_world_camera, i);
  EXPECT_TRUE(records.back().localized);
  const auto keyframes = slam.keyframes();
  EXPECT_GT(keyframes.size(), map.keyframes.size());
  for (std::size_t i = 0; i < keyframes.size(); ++i) EXPECT_EQ(keyframes[i].submap, 0) << i;
  EXPECT_EQ(slam.map().memory->keyframes.size(), keyframes.size());
}

// The walk in another building looks different.
TEST_F(MapsOfSlam, ASessionThatNeverMeetsThemStaysASubmap) {
  const Map map = make_map();
  Slam slam(map, options());
  const SyntheticFrames walk{small_camera(320, 240)};
  constexpr std::size_t kElsewhere = 150;
  for (std::size_t i = 0; i < 20; ++i) slam.track(walk.frame(i, kElsewhere + i));
  slam.finish();
  EXPECT_EQ(slam.keyframes().back().submap, 1);
  EXPECT_EQ(slam.trajectory().poses.size(), 20U) << "in a world of its own";
}

TEST_F(MapsOfSlam, FramesAreLocatedInThem) {
  const Map map = make_map();
  Slam slam(map, options(), MapUse::kLocalize);
  const auto records = track(slam, 10, 35);
  EXPECT_FALSE(records[0].localized) << "one frame may show an ambiguous place";
  std::size_t localized = 0;
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (!records[i].localized) continue;
    ++localized;
    expect_pose(records[i].T_world_camera, 10 + i);
  }
  EXPECT_GT(localized, 20U);
  slam.finish();
  EXPECT_EQ(slam.trajectory().poses.size(), localized);
  EXPECT_EQ(slam.keyframes().size(), map.keyframes.size()) << "it is left as it is";
}

TEST_F(MapsOfSlam, OutsideThemTheCameraIsTrackedButNotLocated) {
  const Map map = make_map();
  Slam slam(map, options(), MapUse::kLocalize);
  const SyntheticFrames walk{small_camera(320, 240)};
  constexpr std::size_t kElsewhere = 150;
  for (std::size_t i = 0; i < 20; ++i) {
    const FrameRecord record = slam.track(walk.frame(i, kElsewhere + i));
    EXPECT_EQ(record.status, TrackingStatus::kTracked) << i;
    EXPECT_FALSE(record.localized) << i;
  }
}

TEST_F(MapsOfSlam, WhatCannotBeLoadedIsAnError) {
  EXPECT_THROW(std::ignore = Slam(Map(), options()), DataError);
  Map map = make_map();
  map.memory->keyframes[1].points.pop_back();
  EXPECT_THROW(std::ignore = Slam(map, options()), DataError);
  map = make_map();
  map.memory->keyframes[1].features.clear();
  EXPECT_THROW(std::ignore = Slam(map, options()), DataError);
  map.memory->keyframes.pop_back();
  EXPECT_THROW(std::ignore = Slam(map, options()), DataError);
}

}  // namespace
}  // namespace cvo_slam
