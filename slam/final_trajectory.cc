// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <utility>

#include "cvo_slam/slam/final_trajectory_internal.h"

namespace cvo_slam {
namespace {

CorrectedPose final_pose(const TrackedPose& frame, const FrameHistory& history,
                         const MapState& map) {
  if (const auto own = map.place_of(frame.frame)) return *own;
  const auto keyframe = map.place_of(frame.keyframe);
  if (!keyframe) return {frame.T_world_camera_online, map.submaps.name_of(frame.tracked_submap)};
  const auto& [T_world_keyframe, submap] = *keyframe;
  const SE3 T_world_camera = T_world_keyframe * frame.T_keyframe_camera;
  const TrackedPose* const next = history.next_keyframe(frame);
  const auto final_next = next == nullptr ? std::nullopt : map.place_of(next->frame);
  if (!final_next) return {T_world_camera.normalized(), submap};
  // Where tracking alone puts the next keyframe.
  const SE3 T_world_next_tracked = T_world_keyframe * next->T_keyframe_camera;
  const SE3 T_tracked_final = T_world_next_tracked.inverse() * final_next->T_world_camera;
  // Shared out by time, see the header.
  const Timestamp begin = history.frame(frame.keyframe).stamp;
  const double share = seconds_between(begin, frame.stamp) / seconds_between(begin, next->stamp);
  return {(T_world_camera * SE3::exp(share * T_tracked_final.log())).normalized(), submap};
}

FrameRecord record_of(const TrackedPose& frame, int submap, const SE3& T_world_camera) {
  FrameRecord record;
  record.index = frame.frame;
  record.stamp = frame.stamp;
  record.status = frame.status;
  record.reason = frame.reason;
  record.submap = submap;
  record.T_world_camera = T_world_camera;
  return record;
}

/// The path in a map that was loaded, if any frame is in it.
Trajectory path_of(std::vector<FrameRecord> records, int first_own_submap) {
  const auto is_in_map = [&](const FrameRecord& record) {
    return record.status == TrackingStatus::kTracked && record.submap < first_own_submap;
  };
  if (std::any_of(records.begin(), records.end(), is_in_map)) {
    for (FrameRecord& record : records) {
      if (record.status == TrackingStatus::kLost || is_in_map(record)) continue;
      record.status = TrackingStatus::kLost;
      record.reason = "not located in the map";
    }
  }
  return to_trajectory(records);
}

}  // namespace

bool FrameHistory::is_consistent() const {
  const auto is_before = [](const TrackedPose& a, const TrackedPose& b) {
    return a.frame < b.frame;
  };
  if (!std::is_sorted(frames_.begin(), frames_.end(), is_before)) return false;
  const auto has = [&](std::size_t number) {
    TrackedPose wanted;
    wanted.frame = number;
    return std::binary_search(frames_.begin(), frames_.end(), wanted, is_before);
  };
  return std::all_of(keyframes_.begin(), keyframes_.end(), has) &&
         std::all_of(frames_.begin(), frames_.end(), [&](const TrackedPose& frame) {
           return frame.status == TrackingStatus::kLost || has(frame.keyframe);
         });
}

const TrackedPose& FrameHistory::frame(std::size_t number) const {
  return *std::lower_bound(
      frames_.begin(), frames_.end(), number,
      [](const TrackedPose& frame, std::size_t index) { return frame.frame < index; });
}

const TrackedPose* FrameHistory::next_keyframe(const TrackedPose& frame) const {
  const auto next = std::upper_bound(keyframes_.begin(), keyframes_.end(), frame.frame);
  if (next == keyframes_.end()) return nullptr;
  const TrackedPose& keyframe = this->frame(*next);
  return keyframe.keyframe == frame.keyframe ? &keyframe : nullptr;
}

Trajectory online_trajectory(const FrameHistory& history, int first_own_submap) {
  std::vector<FrameRecord> records;
  for (const TrackedPose& frame : history.frames()) {
    records.push_back(record_of(frame, frame.submap_online, frame.T_world_camera_online));
  }
  return path_of(std::move(records), first_own_submap);
}

Trajectory final_trajectory(const FrameHistory& history, const MapState& map,
                            int first_own_submap) {
  std::vector<FrameRecord> records;
  for (const TrackedPose& frame : history.frames()) {
    const CorrectedPose pose =
        frame.status == TrackingStatus::kTracked
            ? final_pose(frame, history, map)
            : CorrectedPose{SE3(), map.submaps.name_of(frame.tracked_submap)};
    records.push_back(record_of(frame, pose.submap, pose.T_world_camera));
  }
  return path_of(std::move(records), first_own_submap);
}

}  // namespace cvo_slam
