// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "cvo_slam/backend/optimizer_options.h"
#include "cvo_slam/core/pose_graph.h"

namespace cvo_slam {

/// What a robust edge of squared error s costs, twice: rho(s).
[[nodiscard]] double robust_loss(double s, const OptimizerOptions& options);

/// rho'(s): the share of its information with which the edge counts there.
[[nodiscard]] double robust_weight(double s, const OptimizerOptions& options);

/// Half the sum over all edges; the loss is for the robust ones.
[[nodiscard]] double robust_cost(const PoseGraph& graph, const OptimizerOptions& options);

/// Of each edge; 1 where it is not robust.
[[nodiscard]] std::vector<double> robust_weights(const PoseGraph& graph,
                                                 const OptimizerOptions& options);

}  // namespace cvo_slam
