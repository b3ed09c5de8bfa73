// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "cvo_slam/backend/optimizer.h"
#include "cvo_slam/core/pose_graph.h"

namespace cvo_slam {

/// Returns rho(s), twice the cost of a robust edge with the squared error s.
[[nodiscard]] double robust_loss(double s, const OptimizerOptions& options);

/// Returns rho'(s), the factor by which the loss reduces the edge's information at s.
[[nodiscard]] double robust_weight(double s, const OptimizerOptions& options);

/// Returns the cost of the graph: half the sum over all edges, with the loss for robust ones.
[[nodiscard]] double robust_cost(const PoseGraph& graph, const OptimizerOptions& options);

/// Returns robust_weight() of each edge; 1 for edges that are not robust.
[[nodiscard]] std::vector<double> robust_weights(const PoseGraph& graph,
                                                 const OptimizerOptions& options);

}  // namespace cvo_slam
