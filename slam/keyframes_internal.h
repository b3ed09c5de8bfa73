// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <unordered_map>
#include <vector>

#include "cvo_slam/core/point_cloud.h"
#include "cvo_slam/core/pose_graph.h"
#include "cvo_slam/core/saved_state.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/core/timestamp.h"
#include "cvo_slam/slam/compact_cloud_internal.h"

namespace cvo_slam {

/// The node of a keyframe in the pose graph and in files: its number.
[[nodiscard]] inline NodeId node_id(std::size_t number) { return static_cast<NodeId>(number); }

/// A keyframe of the map, without its pose, which the graph owns.
struct StoredKeyframe {
  std::size_t number = 0;  ///< the index of its frame; a keyframe keeps it for life
  Timestamp stamp;
  /// The submap in which the tracker made it (FrameRecord::submap). Submaps that were joined since
  /// have one name more: see Submaps.
  int tracked_submap = 0;
  CompactCloud cloud;
  double reach = 0;  ///< distance of the farthest point of the cloud from the camera [m]
};

/// Distance of the farthest point of a cloud from its camera [m].
[[nodiscard]] double reach_of(const CompactCloud& cloud);

/// What stands in for a keyframe that was removed.
struct Substitute {
  std::size_t number = 0;  ///< of the keyframe that does
  SE3 T_substitute_keyframe;

  void exchange(SavedState& state) { state(number, T_substitute_keyframe); }
};

/// The keyframes of the map in the order in which they were added. A keyframe's position here is
/// also the index of its node in the pose graph.
class KeyframeStore {
 public:
  /// Adds a keyframe and measures its reach.
  void add(StoredKeyframe keyframe);
  /// Removes the keyframe at a position; the positions of later ones decrease by one.
  void remove(std::size_t position, const Substitute& substitute);

  [[nodiscard]] std::size_t size() const { return keyframes_.size(); }
  [[nodiscard]] bool empty() const { return keyframes_.empty(); }
  [[nodiscard]] const StoredKeyframe& operator[](std::size_t position) const {
    return keyframes_[position];
  }
  [[nodiscard]] const StoredKeyframe& newest() const { return keyframes_.back(); }
  /// The position of a keyframe that is in the store.
  [[nodiscard]] std::size_t position_of(std::size_t number) const { return positions_.at(number); }
  [[nodiscard]] bool has(std::size_t number) const { return positions_.contains(number); }
  /// What stands in for a keyframe that was removed, which may have been removed since; null for
  /// any other number.
  [[nodiscard]] const Substitute* substitute_for(std::size_t number) const;
  /// Memory of the keyframes and their points [bytes].
  [[nodiscard]] std::size_t bytes() const { return bytes_; }
  /// What stands in for those that were removed.
  void exchange(SavedState& state);

 private:
  std::vector<StoredKeyframe> keyframes_;
  std::unordered_map<std::size_t, std::size_t> positions_;   // by number
  std::unordered_map<std::size_t, Substitute> substitutes_;  // of those removed, by number
  std::size_t bytes_ = 0;
};

}  // namespace cvo_slam
