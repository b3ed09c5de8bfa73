// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <unordered_set>
#include <vector>

#include "cvo_slam/backend/optimizer.h"
#include "cvo_slam/core/pose_graph.h"

namespace cvo_slam {

class SavedState;

/// The nodes that an optimisation may move.
enum class OptimizationScope {
  kWindow,  ///< nodes at most OptimizerOptions::window edges from the newest; all others are held
  kFull,    ///< every node
};

/// A pose graph that grows and is optimised repeatedly, each time from the poses of the last
/// optimisation. Adding nodes and edges does not take longer in a larger graph.
class PoseGraphOptimizer {
 public:
  /// Throws OptionError if an option is out of range.
  explicit PoseGraphOptimizer(const OptimizerOptions& options = {});

  ///@{
  /// Changes the graph as the function of PoseGraph with the same name does.
  void add_node(const PoseGraphNode& node) { graph_.add_node(node); }
  void add_edge(const PoseGraphEdge& edge);
  void remove_edge(std::size_t index);
  void remove_node(std::size_t index);
  void set_pose(std::size_t index, const SE3& T_world_node) {
    graph_.set_pose(index, T_world_node);
  }
  ///@}

  /// Optimises the graph. The newest node is the one added last. The time of a window depends on
  /// the size of the window, not of the graph (apart from copying the list of weights); its search
  /// starts at the present poses, whatever the option says. The costs and iterations of a window's
  /// summary are those of the edges of free nodes; the weights are those of all edges of the graph.
  Summary optimize(OptimizationScope scope = OptimizationScope::kWindow);

  /// Returns the graph with its present poses.
  [[nodiscard]] const PoseGraph& graph() const { return graph_; }
  /// Weight of each edge in the last optimisation that included it (Summary::weights); 1 before.
  [[nodiscard]] const std::vector<double>& weights() const { return weights_; }
  /// Indices in nodes() of the nodes whose poses the last optimisation may have changed; none after
  /// a node was removed.
  [[nodiscard]] const std::vector<std::size_t>& moved() const { return moved_; }

  /// Writes the graph and the weights, or replaces them. Throws DataError if the bytes are not
  /// those of a graph.
  void exchange(SavedState& state);

 private:
  [[nodiscard]] std::unordered_set<std::size_t> free_nodes_near_newest() const;
  Summary optimize_window();

  OptimizerOptions options_;
  PoseGraph graph_;
  std::vector<double> weights_;
  std::vector<std::size_t> moved_;
};

}  // namespace cvo_slam
