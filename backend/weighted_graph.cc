// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/backend/weighted_graph_internal.h"

namespace cvo_slam {

PoseGraph weighted_graph(const PoseGraph& graph, const std::vector<double>& weights) {
  PoseGraph result;
  for (const PoseGraphNode& node : graph.nodes()) result.add_node(node);
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i] <= 0) continue;
    PoseGraphEdge edge = graph.edges()[i];
    edge.information *= weights[i];
    result.add_edge(edge);
  }
  return result;
}

}  // namespace cvo_slam
