// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "cvo_slam/core/saved_state.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/slam/keyframes_internal.h"
#include "cvo_slam/slam/map_graph_internal.h"
#include "cvo_slam/slam/submaps_internal.h"

namespace cvo_slam {

/// A motion that nobody tracked, from the last keyframe of a submap to the first of the next one:
/// where the camera is if it stood still, with the covariance of how far it may have come.
struct Gap {
  std::size_t from = 0;  ///< position of the last keyframe
  std::size_t to = 0;    ///< position of the first keyframe
  SE3 T_from_to;
  EdgeCovariances covariances;

  void exchange(SavedState& state) { state(from, to, T_from_to, covariances); }
};

/// Mean of cos_theta over the registrations of consecutive keyframes: what is usual in this scene.
struct UsualCosTheta {
  double sum = 0;
  std::size_t count = 0;

  [[nodiscard]] double mean() const { return count == 0 ? 0 : sum / static_cast<double>(count); }
  void exchange(SavedState& state) { state(sum, count); }
};

/// Where the map has a keyframe.
struct CorrectedPose {
  SE3 T_world_camera;
  int submap = 0;  ///< name of the joined submaps that it belongs to

  void exchange(SavedState& state) { state(T_world_camera, submap); }
};

/// All that the stages of mapping read. The mapper alone changes it.
struct MapState {
  explicit MapState(const OptimizerOptions& optimizer) : graph(optimizer) {}

  KeyframeStore keyframes;
  MapGraph graph;
  Submaps submaps;
  std::vector<Gap> gaps;
  std::vector<SubmapLink> links;           ///< between submaps, until enough agree
  std::vector<SubmapLink> contradictions;  ///< that the graph does not believe
  UsualCosTheta usual_cos_theta;
  /// Number of keyframes, the first ones, that are those of a map that was loaded. The clocks and
  /// the way of the camera between these and the others are not known.
  std::size_t loaded = 0;

  [[nodiscard]] bool has_own_keyframes() const { return keyframes.size() > loaded; }
  [[nodiscard]] int submap_at(std::size_t position) const {
    return submaps.name_of(keyframes[position].tracked_submap);
  }
  /// Where a keyframe is, given by its number, also if another one stands in for it; none if the
  /// map never had it.
  [[nodiscard]] std::optional<CorrectedPose> place_of(std::size_t number) const;
  /// All but the keyframes, which are there.
  void exchange(SavedState& state);
};

}  // namespace cvo_slam
