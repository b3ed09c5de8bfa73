// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "cvo_slam/backend/optimizer.h"
#include "cvo_slam/backend/optimizer_options.h"
#include "cvo_slam/core/pose_graph.h"

namespace cvo_slam {

enum class OptimizationScope {
  kWindow,  ///< nodes at most OptimizerOptions::window edges from the newest; all others are held
  kFull,    ///< every node
};

/// A pose graph that grows and is optimised again and again, each time from where the last
/// optimisation left the poses.
class PoseGraphOptimizer {
 public:
  /// Throws OptionError where an option is out of range.
  explicit PoseGraphOptimizer(const OptimizerOptions& options = {});

  /// As PoseGraph's.
  void add_node(const PoseGraphNode& node);
  void add_edge(const PoseGraphEdge& edge);
  void remove_edge(std::size_t index);
  void set_pose(std::size_t index, const SE3& T_world_node) {
    graph_.set_pose(index, T_world_node);
  }

  /// A window's time depends on the window's size, not on the graph's (apart from a few passes over
  /// the lists of nodes and edges); it starts at the given poses, whatever the option says. The
  /// newest node is the one added last. Of a window, the summary's costs and iterations are those
  /// of the edges that a free node has; its weights are those of all edges of the graph.
  Summary optimize(OptimizationScope scope = OptimizationScope::kWindow);

  [[nodiscard]] const PoseGraph& graph() const { return graph_; }
  /// Of each edge, from the last optimisation that it took part in (Summary::weights); 1 before.
  [[nodiscard]] const std::vector<double>& weights() const { return weights_; }

  /// Indices of the nodes whose poses the last optimisation may have changed.
  [[nodiscard]] const std::vector<std::size_t>& moved() const { return moved_; }

 private:
  [[nodiscard]] std::vector<bool> nodes_near_newest() const;
  Summary optimize_window();

  OptimizerOptions options_;
  PoseGraph graph_;
  std::vector<std::size_t> moved_;
  std::vector<double> weights_;
};

}  // namespace cvo_slam
