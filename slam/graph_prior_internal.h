// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <queue>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "cvo_slam/core/timestamp.h"
#include "cvo_slam/slam/map_graph_internal.h"
#include "cvo_slam/slam/map_state_internal.h"
#include "cvo_slam/slam/pair_registration_internal.h"

namespace cvo_slam {

/// Finds the most certain paths of edges from one keyframe to others, nearest first, and no further
/// than it is asked (Dijkstra's algorithm on the trace of the covariance). The covariance along one
/// path is larger than the true one, to which all paths contribute, but needs no factorisation of
/// the graph. It sees the edges that the graph has when it is made, and must not outlive a removal.
class PathSearch {
 public:
  /// `gaps` are walked like edges.
  PathSearch(const MapGraph& graph, std::size_t source, std::span<const Gap> gaps = {});

  /// Covariance of a right perturbation of T_source_target; none if no path leads to the target.
  /// Its cost grows with the number of keyframes that are less uncertain than the target.
  [[nodiscard]] std::optional<Matrix6> covariance_to(std::size_t target);

 private:
  struct Reached {
    Matrix6 covariance = Matrix6::Zero();
    double variance = std::numeric_limits<double>::infinity();  // its trace [m^2 + rad^2]
    bool settled = false;
  };
  using Frontier = std::pair<double, std::size_t>;  // variance, position

  void leave(std::size_t position);
  void step(const Matrix6& covariance, std::size_t target, const SE3& T_position_target,
            const Matrix6& step_covariance);

  const MapGraph& graph_;
  std::span<const Gap> gaps_;
  std::size_t edge_count_;
  std::unordered_map<std::size_t, Reached> reached_;
  std::priority_queue<Frontier, std::vector<Frontier>, std::greater<>> open_;
};

/// What the graph says of the pose of the newest keyframe relative to an earlier one. `covariance`
/// is that of PathSearch from the newest to the earlier one.
[[nodiscard]] PairPrior graph_prior(const MapGraph& graph, std::size_t older_position,
                                    std::size_t newest_position, const Matrix6& covariance);

/// Covariance of the motion of a camera during a time without tracking [s].
[[nodiscard]] Matrix6 untracked_covariance(double seconds, const RelocalizationOptions& options);

/// What the graph and the gaps between its submaps say of a camera that is at `now` where the
/// newest keyframe was, or has moved untracked since, relative to an earlier keyframe; none if the
/// orientation is too uncertain to be of use.
[[nodiscard]] std::optional<PairPrior> prior_across_gaps(const MapState& map,
                                                         std::size_t older_position,
                                                         const Timestamp& now,
                                                         const RelocalizationOptions& options);

}  // namespace cvo_slam
