// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "cvo_slam/backend/pose_graph_optimizer.h"
#include "cvo_slam/core/pose_graph.h"
#include "cvo_slam/slam/pair_registration_internal.h"

namespace cvo_slam {

/// Covariances of an edge's measurement, each of a right perturbation.
struct EdgeCovariances {
  Matrix6 from_to = Matrix6::Zero();  ///< of T_from_to
  Matrix6 to_from = Matrix6::Zero();  ///< of T_from_to^-1
};

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
    return covariances_[edge];
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
  Summary optimize(OptimizationScope scope) { return optimizer_.optimize(scope); }
  /// Positions of the keyframes whose poses the last optimisation may have changed.
  [[nodiscard]] const std::vector<std::size_t>& moved() const { return optimizer_.moved(); }

 private:
  PoseGraphOptimizer optimizer_;
  // Parallel to the graph's edges.
  std::vector<EdgeCovariances> covariances_;
  std::vector<std::optional<std::size_t>> rows_;
};

}  // namespace cvo_slam
