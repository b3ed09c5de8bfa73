// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "cvo_slam/backend/connectivity_internal.h"

namespace cvo_slam {
namespace {

/// Sets of nodes that edges join, as trees. All fixed nodes are in one set.
class NodeSets {
 public:
  explicit NodeSets(const PoseGraph& graph) : graph_(graph), parent_(graph.nodes().size()) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    std::optional<std::size_t> first_fixed;
    for (std::size_t i = 0; i < parent_.size(); ++i) {
      if (!graph.nodes()[i].fixed) continue;
      if (!first_fixed) first_fixed = i;
      parent_[i] = *first_fixed;
    }
  }

  /// Joins the ends of an edge. Returns false if they were in one set already.
  bool join(std::size_t edge) {
    const std::size_t a = root(graph_.ends()[edge].first);
    const std::size_t b = root(graph_.ends()[edge].second);
    parent_[a] = b;
    return a != b;
  }

 private:
  std::size_t root(std::size_t node) {
    while (parent_[node] != node) {
      parent_[node] = parent_[parent_[node]];  // halves the path for the next search
      node = parent_[node];
    }
    return node;
  }

  const PoseGraph& graph_;
  std::vector<std::size_t> parent_;
};

bool is_rejected(double weight) { return weight < 0.5; }

std::string name_of(const PoseGraphEdge& edge) {
  return fmt::format("{} -> {}", edge.from, edge.to);
}

/// Returns the edges of `kept` without which a part would come loose in the end.
std::vector<std::size_t> bridges_among(const PoseGraph& graph, const std::vector<double>& weights,
                                       std::vector<std::size_t> kept) {
  std::sort(kept.begin(), kept.end());
  kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
  NodeSets sets(graph);
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const bool is_kept = std::binary_search(kept.begin(), kept.end(), i);
    if (!is_kept && !is_rejected(weights[i])) sets.join(i);
  }
  std::erase_if(kept, [&](std::size_t i) { return is_rejected(weights[i]) || !sets.join(i); });
  return kept;
}

/// Returns true if an edge that may be wrong was accepted and closes a loop.
bool closes_a_loop(const PoseGraph& graph, const std::vector<double>& weights) {
  NodeSets sets(graph);
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (!graph.edges()[i].robust) sets.join(i);
  }
  bool closes = false;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (graph.edges()[i].robust && !is_rejected(weights[i])) closes = !sets.join(i) || closes;
  }
  return closes;
}

}  // namespace

std::vector<std::size_t> reconnect_parts(const PoseGraph& graph, std::vector<double>& weights) {
  NodeSets sets(graph);
  std::vector<std::pair<double, std::size_t>> rejected;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i] > 0) {
      sets.join(i);
    } else {
      rejected.emplace_back(squared_error(graph, i), i);
    }
  }
  std::sort(rejected.begin(), rejected.end());
  std::vector<std::size_t> kept;
  for (const auto& [error, edge] : rejected) {
    if (!sets.join(edge)) continue;
    weights[edge] = 1;
    kept.push_back(edge);
  }
  return kept;
}

std::vector<std::string> connectivity_notes(const PoseGraph& graph,
                                            const std::vector<double>& weights,
                                            const std::vector<std::size_t>& kept) {
  std::vector<std::string> notes;
  const std::vector<std::size_t> bridges = bridges_among(graph, weights, kept);
  if (!bridges.empty()) {
    notes.push_back(
        fmt::format("{} edge{} kept that the loss rejected, the best of those without which a part "
                    "of the graph would come loose ({}{}): check the edges to that part",
                    bridges.size(), bridges.size() == 1 ? "" : "s",
                    name_of(graph.edges()[bridges.front()]), bridges.size() > 1 ? ", ..." : ""));
  }
  const auto rejected = std::count_if(weights.begin(), weights.end(), is_rejected);
  if (rejected > 0 && !closes_a_loop(graph, weights)) {
    notes.push_back(fmt::format(
        "all that closes a loop was rejected, {} edge{}: the result is a chain of odometry; check "
        "these edges and the information matrices, or raise the scale of the loss",
        rejected, rejected == 1 ? "" : "s"));
  }
  return notes;
}

}  // namespace cvo_slam
