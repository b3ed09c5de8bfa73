// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a robust loss does to the connections of a graph.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cvo_slam/core/pose_graph.h"

namespace cvo_slam {

/// Gives weight 1 to rejected edges (weight 0) that reconnect what all edges connect and the edges
/// with a weight do not: of the edges between two parts the one with the smallest squared error.
/// Fixed nodes count as connected, because their poses are known. Returns the indices of these
/// edges.
std::vector<std::size_t> reconnect_parts(const PoseGraph& graph, std::vector<double>& weights);

/// Returns the notes of Summary on the weights that a robust loss gave the edges; `kept` are the
/// edges that reconnect_parts() ever returned.
[[nodiscard]] std::vector<std::string> connectivity_notes(const PoseGraph& graph,
                                                          const std::vector<double>& weights,
                                                          const std::vector<std::size_t>& kept);

}  // namespace cvo_slam
