// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <vector>

#include "cvo_slam/core/pose_graph.h"
#include "cvo_slam/core/saved_state.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/core/timestamp.h"
#include "cvo_slam/core/trajectory.h"
#include "cvo_slam/frontend/tracker.h"
#include "cvo_slam/slam/map_state_internal.h"

namespace cvo_slam {

/// What is kept of a frame: how it was tracked, and what track() answered.
struct TrackedPose {
  std::size_t frame = 0;
  Timestamp stamp;
  TrackingStatus status = TrackingStatus::kLost;
  std::string reason;  ///< why it is lost
  int tracked_submap = 0;
  std::size_t keyframe = 0;  ///< number of the keyframe it was registered to
  SE3 T_keyframe_camera;
  SE3 T_world_camera_online;  ///< as track() answered
  int submap_online = 0;      ///< as track() answered

  void exchange(SavedState& state) {
    state(frame, stamp, status, reason, tracked_submap, keyframe, T_keyframe_camera,
          T_world_camera_online, submap_online);
  }
};

/// The frames of a sequence, in ascending order, and which of them are keyframes.
class FrameHistory {
 public:
  void add(TrackedPose pose) { frames_.push_back(std::move(pose)); }
  void add_keyframe(std::size_t number) { keyframes_.push_back(number); }

  [[nodiscard]] bool empty() const { return frames_.empty(); }
  [[nodiscard]] const TrackedPose& newest() const { return frames_.back(); }
  /// Seconds from the newest frame to a time; 0 if there is none.
  [[nodiscard]] double seconds_until(const Timestamp& stamp) const {
    return empty() ? 0 : seconds_between(newest().stamp, stamp);
  }
  /// The frame of a number that is in the history.
  [[nodiscard]] const TrackedPose& frame(std::size_t number) const;
  [[nodiscard]] const std::deque<TrackedPose>& frames() const { return frames_; }
  /// The keyframe after a frame, if it was tracked against the same keyframe; otherwise null.
  [[nodiscard]] const TrackedPose* next_keyframe(const TrackedPose& frame) const;
  void exchange(SavedState& state) { state(frames_, keyframes_); }
  /// True if the frames ascend, and those that keyframes are named by are among them.
  [[nodiscard]] bool is_consistent() const;

 private:
  std::deque<TrackedPose> frames_;
  std::vector<std::size_t> keyframes_;  // that were handed to the mapper
};

/// Every frame with the pose and the submap that track() answered; those of the submap with most
/// frames, or if there are any, those of the submaps before `first_own_submap`: of a map that was
/// loaded.
[[nodiscard]] Trajectory online_trajectory(const FrameHistory& history, int first_own_submap);

/// Every frame attached to its keyframe as the map has that now. What the map has corrected between
/// two keyframes is shared out by time among the frames between. A frame whose keyframe the map
/// does not have yet keeps its online pose.
[[nodiscard]] Trajectory final_trajectory(const FrameHistory& history, const MapState& map,
                                          int first_own_submap);

}  // namespace cvo_slam
