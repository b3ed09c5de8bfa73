// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the sources of Slam share: slam.cc follows a frame's way, slam_state.cc saves it.
#pragma once

#include <atomic>
#include <cstddef>
#include <deque>
#include <exception>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "cvo_slam/core/exclusive_access.h"
#include "cvo_slam/core/saved_state.h"
#include "cvo_slam/slam/feature_start_internal.h"
#include "cvo_slam/slam/final_trajectory_internal.h"
#include "cvo_slam/slam/job_queue_internal.h"
#include "cvo_slam/slam/mapper_internal.h"
#include "cvo_slam/slam/slam.h"

namespace cvo_slam {

/// What the map says after it has taken in a keyframe.
struct MapUpdate {
  CorrectedPose newest;
  std::vector<Keyframe> moved;  // empty if nobody asks

  void exchange(SavedState& state) { state(newest); }
};

/// A keyframe handed to the mapper, done or not, whose correction is not applied yet.
struct SubmittedKeyframe {
  int tracked_submap = 0;
  SE3 T_world_camera_tracked;
  std::shared_ptr<MapUpdate> update;  // written by the job

  /// Only while no job is in work.
  void exchange(SavedState& state) {
    if (state.is_reading()) update = std::make_shared<MapUpdate>();
    state(tracked_submap, T_world_camera_tracked, *update);
  }
};

/// Where the map has a tracked submap.
struct Correction {
  int submap = 0;
  SE3 T_corrected_tracked;

  void exchange(SavedState& state) { state(submap, T_corrected_tracked); }
};

struct Slam::Impl {
  Impl(const Camera& camera, const SlamOptions& options_in,
       const std::shared_ptr<const Vocabulary>& vocabulary);

  std::atomic_flag in_use;  // see ExclusiveAccess
  SlamOptions options;
  double depth_offset;  // of the camera [s]
  Tracker tracker;
  FrameHistory history;
  FrameRecord last_tracked_record;           // of the last tracked frame, as the tracker answered
  PoseConsensus consensus;                   // of the frames since tracking was lost
  std::optional<RecognizedPose> recognized;  // of the newest keyframe, before the mapper has it
  std::optional<MapUse> map_use;             // of a map that was loaded
  std::size_t first_number = 0;              // of a frame with the index 0
  int first_submap = 0;                      // of the tracker's submap 0
  SE3 T_map_last_keyframe;                   // of a camera that is located in a map
  double path_since_located = 0;  // of its keyframes since its place there was measured [m]
  bool is_located = false;        // since the last keyframe, or frame while it is not
  std::deque<SubmittedKeyframe> submitted;  // in ascending order
  std::map<int, Correction> corrections;    // by tracked submap
  SlamObserver observer;
  std::vector<std::vector<Keyframe>> moved;  // that the observer does not know yet
  Mapper mapper;
  std::optional<FeatureStart> start;  // where images may be compared by features
  JobQueue jobs;                      // the last member: its thread ends before what it works on

  FrameRecord track(RgbdFrame frame);
  FrameRecord track_and_notify(const RgbdFrame& frame);
  void notify_of_corrections(std::exception_ptr& thrown);
  void load(const Map& map, MapUse use);
  void exchange(SavedState& state, const Map& map);
  [[nodiscard]] Map map(MapContent content);
  void localize(const RgbdFrame& frame, const FrameRecord& tracked);
  [[nodiscard]] FrameRecord relocalize(const RgbdFrame& frame, const FrameRecord& lost);
  void keep_keyframe(const TrackerKeyframe& keyframe);
  void submit(const TrackerKeyframe& keyframe);
  void apply_corrections(std::size_t left);
  [[nodiscard]] FrameRecord in_map(FrameRecord record) const;
  void finish();
  /// The map without work under way.
  [[nodiscard]] const MapState& finished_map() {
    jobs.wait_until_left(0);
    return mapper.map();
  }
};

}  // namespace cvo_slam
