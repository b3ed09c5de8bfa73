// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "cvo_slam/backend/pose_graph_optimizer.h"
#include "cvo_slam/core/pose_graph.h"
#include "cvo_slam/core/saved_state.h"
#include "cvo_slam/slam/pair_registration_internal.h"

namespace cvo_slam {

/// Covariances of an edge's measurement, each of a right perturbation.
struct EdgeCovariances {
  Matrix6 from_to = Matrix6::Zero();  ///< of T_from_to
  Matrix6 to_from = Matrix6::Zero();  ///< of T_from_to^-1

  void exchange(SavedState& state) { state(from_to, to_from); }
};

/// The covariance of a right perturbation in another frame: Ad(T) covariance Ad(T)^T.
[[nodiscard]] Matrix6 transformed(const Matrix6& covariance, const SE3& T);

[[nodiscard]] EdgeCovariances both_ways(const SE3& T_from_to, const Matrix6& covariance);

/// The pose graph of the keyframes. It owns their poses, and remembers of each edge its covariances
/// and the row of loops.csv that it came from.
class MapGraph {
 public:
  explicit MapGraph(const OptimizerOptions& options) : optimizer_(options) {}

  [[nodiscard]] const PoseGraph& graph() const { return optimizer_.graph(); }
  [[nodiscard]] const SE3& pose(std::size_t position) const {
    return graph().nodes()[position].T_world_node;
  }
  [[nodiscard]] const EdgeCovariances& covariances(std::size_t edge) const {
    return notes_[edge].covariances;
  }
  void add_keyframe(std::size_t number, const SE3& T_world_camera);
  void set_pose(std::size_t position, const SE3& T_world_camera) {
    optimizer_.set_pose(position, T_world_camera);
  }
  /// Connects two keyframes, given by their numbers. All edges but those of odometry may be wrong,
  /// so that the robust loss holds for them. `row` is none for an edge that is no candidate's.
  void add_edge(EdgeKind kind, std::size_t older, std::size_t newer,
                const PairMeasurement& measurement, std::optional<std::size_t> row);
  /// Adds an edge as another map had it.
  void restore_edge(const PoseGraphEdge& edge);
  /// Removes an edge and returns its row.
  std::optional<std::size_t> remove_edge(std::size_t index);
  /// Removes a keyframe, for which the other end of one of its edges stands in: that one inherits
  /// what was measured to others, unless it has been measured there already. What the edge between
  /// the two knows is shared out among what is inherited, so that nothing is counted twice.
  void replace_keyframe(std::size_t position, std::size_t edge);
  Summary optimize(OptimizationScope scope) { return optimizer_.optimize(scope); }
  /// Positions of the keyframes whose poses the last optimisation may have changed.
  [[nodiscard]] const std::vector<std::size_t>& moved() const { return optimizer_.moved(); }
  void exchange(SavedState& state);
  /// True if the rows of all edges are among the first `count`.
  [[nodiscard]] bool has_rows_below(std::size_t count) const;

 private:
  /// What the graph does not know of an edge.
  struct EdgeNotes {
    EdgeCovariances covariances;
    std::optional<std::size_t> row;

    void exchange(SavedState& state) { state(covariances, row); }
  };

  /// An edge as the other end of another edge of the same node inherits it.
  struct InheritedEdge {
    EdgeKind kind = EdgeKind::kProximity;
    std::size_t other = 0;  // position of its far end
    SE3 T_node_other;
    Matrix6 covariance = Matrix6::Zero();  // of a right perturbation
    std::optional<std::size_t> row;
  };

  [[nodiscard]] InheritedEdge seen_from(std::size_t position, std::size_t edge) const;
  [[nodiscard]] bool is_known(std::size_t position, const InheritedEdge& edge) const;

  PoseGraphOptimizer optimizer_;
  std::vector<EdgeNotes> notes_;  // parallel to the graph's edges
};

}  // namespace cvo_slam
