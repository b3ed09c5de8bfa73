// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cvo_slam/backend/optimizer_options.h"
#include "cvo_slam/core/pose_graph.h"

namespace cvo_slam {

/// How an optimisation went. Costs are half the sum of the edges' squared errors, robust edges'
/// under the loss (RobustLoss): what is minimised, in Ceres' convention (pose_graph_cost.h).
struct Summary {
  double initial_cost = 0;  ///< at the poses that were given
  double final_cost = 0;
  int iterations = 0;  ///< of Ceres, over all solves but the rough ones of RobustLoss::kGnc
  int solves = 0;      ///< more than one where RobustLoss::kGnc changed its mind at the end
  bool converged = false;
  std::string reason;            ///< why it ended, in words
  bool started_chordal = false;  ///< at the chordal poses and not at the given ones
  std::vector<double> weights;   ///< of each edge, in [0, 1]; below 0.5: taken for wrong
  double seconds = 0;            ///< wall time

  [[nodiscard]] std::size_t rejected_edges() const;
};

/// Moves the nodes of the graph to the least-squares optimum; held ones (PoseGraph::held_nodes)
/// stay. The result has the same bytes whatever the number of threads. Throws OptionError where an
/// option is out of range. A graph in which nothing can be moved is left as it is, and has
/// converged.
Summary optimize(PoseGraph& graph, const OptimizerOptions& options = {});

}  // namespace cvo_slam
