// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "cvo_slam/backend/optimizer_options.h"
#include "cvo_slam/core/pose_graph.h"

namespace cvo_slam {

struct MinimizeReport {
  int iterations = 0;
  bool converged = false;
  std::string reason;
};

/// Moves the nodes that are not held to a local minimum of the cost, with Ceres, from where they
/// are. The losses kHuber and kCauchy are applied to robust edges; kGnc is left to the caller, who
/// weights the information matrices.
MinimizeReport minimize(PoseGraph& graph, const OptimizerOptions& options);

}  // namespace cvo_slam
