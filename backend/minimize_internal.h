// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "cvo_slam/backend/optimizer.h"
#include "cvo_slam/core/pose_graph.h"

namespace cvo_slam {

/// Moves the poses to where the search is to start (OptimizerOptions::initialization). Returns true
/// if those are the chordal poses.
bool choose_start(PoseGraph& graph, const OptimizerOptions& options);

struct MinimizeReport {
  int iterations = 0;
  bool converged = false;
  std::string reason;
};

/// Moves the nodes that are not held to a local minimum of the cost, with Ceres, from their present
/// poses. The losses kHuber and kCauchy are applied to robust edges; for kGnc the caller weights
/// the information matrices.
MinimizeReport minimize(PoseGraph& graph, const OptimizerOptions& options);

}  // namespace cvo_slam
