// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cvo_slam/backend/optimizer.h"

namespace cvo_slam {

/// Returns the weight of a measurement with the squared error s under the truncated least-squares
/// loss min(s, c^2), made less convex as mu grows from 0 to infinity: H. Yang et al., "Graduated
/// Non-Convexity for Robust Spatial Perception", RA-L 2020, Eq. (14).
[[nodiscard]] double gnc_weight(double s, double c2, double mu);

/// How a search for the optimum went; the members are those of Summary.
struct SearchReport {
  int iterations = 0;
  int solves = 0;
  bool converged = false;
  std::string reason;
  bool started_chordal = false;
  std::vector<double> weights;
  std::vector<std::size_t> kept;  ///< edges that were rejected, but that reconnect_parts() kept
};

/// Fits the graph repeatedly, weighting its robust edges, until each of them is accepted or
/// rejected; then solves the graph with the accepted ones.
SearchReport graduate(PoseGraph& graph, const OptimizerOptions& options);

}  // namespace cvo_slam
