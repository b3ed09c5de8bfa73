// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "cvo_slam/core/saved_state.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/slam/pair_registration_internal.h"
#include "cvo_slam/slam/slam_options.h"

namespace cvo_slam {

struct MapState;

/// Which of the submaps that the tracker made are joined. Keyframes of one tracked submap are
/// always connected, by their odometry edges; those of different ones are where an edge joins them.
/// Joined submaps share the name of the first of them.
class Submaps {
 public:
  /// The name of the joined submaps that this one belongs to.
  [[nodiscard]] int name_of(int tracked_submap) const;
  /// Records that an edge connects the two.
  void join(int a, int b);
  /// Forgets all joins.
  void clear() { names_.clear(); }
  void exchange(SavedState& state) { state(names_); }

 private:
  std::map<int, int> names_;  // of those that do not bear their own
};

/// A keyframe of one submap that was recognised in a keyframe of another one, and registered to it.
struct SubmapLink {
  std::size_t older = 0;  ///< number of the recognised keyframe
  std::size_t newer = 0;  ///< number of the keyframe that recognised it
  PairMeasurement measurement;
  std::size_t row = 0;  ///< in the list of candidates

  void exchange(SavedState& state) { state(older, newer, measurement, row); }
};

/// What all links between two submaps say together.
struct SubmapPlacement {
  std::vector<SubmapLink> agreeing;  ///< the largest set of links that say the same
  std::size_t keyframes = 0;         ///< number of newer keyframes among these
  std::size_t rivals = 0;  ///< number of newer keyframes in the largest set of the other links
  SE3 T_world_world;       ///< from the newer keyframes' world to that of the older ones

  /// True if the set is large enough, and at least twice as large as that of its rivals.
  [[nodiscard]] bool is_certain(const RelocalizationOptions& options) const;
};

/// Where the largest set of links that agree puts one submap in the other. All links lead from the
/// same submap (older keyframes) to the same other one (newer keyframes).
[[nodiscard]] SubmapPlacement place_submap(const std::vector<SubmapLink>& links,
                                           const MapState& map,
                                           const RelocalizationOptions& options);

/// A decision to join two submaps.
struct SubmapJoin {
  int moved = 0;                  ///< name of the submap whose poses change their world
  SE3 T_new_old;                  ///< its old world in its new one
  std::vector<SubmapLink> links;  ///< become edges
};

/// Joins the newest keyframe's submap with another one if enough of `links` agree on how; one at a
/// time, because what other links say may change with it.
[[nodiscard]] std::optional<SubmapJoin> find_join(const std::vector<SubmapLink>& links,
                                                  const MapState& map,
                                                  const RelocalizationOptions& options);

/// A decision to separate the newest tracked submap from those it was joined with, because more
/// keyframes place it elsewhere than have joined it.
struct SubmapSeparation {
  std::vector<std::size_t> edges;  ///< indices of the edges to remove, descending
  std::size_t keyframes = 0;       ///< number of keyframes that place the submap elsewhere
  std::vector<SubmapLink> links;   ///< what these say
};

/// `contradictions` are links that the graph does not believe.
[[nodiscard]] std::optional<SubmapSeparation> find_separation(
    const std::vector<SubmapLink>& contradictions, const MapState& map,
    const RelocalizationOptions& options);

/// The joins that the edges of the graph make.
[[nodiscard]] Submaps submaps_of(const MapState& map);

}  // namespace cvo_slam
