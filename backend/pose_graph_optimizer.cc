// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/backend/pose_graph_optimizer.h"

#include <numeric>

namespace cvo_slam {
namespace {

/// The edges that a free node has, with their ends, of which those that are not free are fixed.
struct Window {
  PoseGraph graph;
  std::vector<std::size_t> nodes;  // their indices in the whole graph
  std::vector<std::size_t> edges;
};

Window make_window(const PoseGraph& graph, const std::vector<bool>& is_free) {
  Window window;
  std::vector<bool> taken(graph.nodes().size());
  const auto take = [&](std::size_t i) {
    if (taken[i]) return;
    taken[i] = true;
    PoseGraphNode node = graph.nodes()[i];
    node.fixed = !is_free[i];
    window.graph.add_node(node);
    window.nodes.push_back(i);
  };
  for (std::size_t i = 0; i < graph.edges().size(); ++i) {
    const auto [a, b] = graph.ends()[i];
    if (!is_free[a] && !is_free[b]) continue;
    take(a);
    take(b);
    window.graph.add_edge(graph.edges()[i]);
    window.edges.push_back(i);
  }
  return window;
}

}  // namespace

PoseGraphOptimizer::PoseGraphOptimizer(const OptimizerOptions& options) : options_(options) {
  describe(options_).check();
}

void PoseGraphOptimizer::add_node(const PoseGraphNode& node) { graph_.add_node(node); }

void PoseGraphOptimizer::add_edge(const PoseGraphEdge& edge) {
  graph_.add_edge(edge);
  weights_.push_back(1);
}

void PoseGraphOptimizer::remove_edge(std::size_t index) {
  graph_.remove_edge(index);
  weights_.erase(weights_.begin() + static_cast<std::ptrdiff_t>(index));
}

Summary PoseGraphOptimizer::optimize(OptimizationScope scope) {
  moved_.clear();
  if (scope == OptimizationScope::kWindow) return optimize_window();
  moved_.resize(graph_.nodes().size());
  std::iota(moved_.begin(), moved_.end(), std::size_t{0});
  Summary summary = cvo_slam::optimize(graph_, options_);
  weights_ = summary.weights;
  return summary;
}

std::vector<bool> PoseGraphOptimizer::nodes_near_newest() const {
  std::vector<bool> near(graph_.nodes().size());
  if (near.empty()) return near;
  std::vector<std::size_t> ring = {near.size() - 1};
  near.back() = true;
  for (int distance = 0; distance < options_.window && !ring.empty(); ++distance) {
    std::vector<std::size_t> next;
    for (const std::size_t node : ring) {
      for (const std::size_t edge : graph_.edges_of(node)) {
        const auto [a, b] = graph_.ends()[edge];
        const std::size_t other = a == node ? b : a;
        if (near[other] || weights_[edge] < 0.5) continue;  // a rejected edge leads nowhere
        near[other] = true;
        next.push_back(other);
      }
    }
    ring = std::move(next);
  }
  return near;
}

Summary PoseGraphOptimizer::optimize_window() {
  std::vector<bool> is_free = nodes_near_newest();
  const std::vector<bool> held = graph_.held_nodes();
  for (std::size_t i = 0; i < held.size(); ++i) is_free[i] = is_free[i] && !held[i];
  Window window = make_window(graph_, is_free);
  OptimizerOptions options = options_;
  options.initialization = Initialization::kGiven;
  Summary summary = cvo_slam::optimize(window.graph, options);
  for (std::size_t i = 0; i < window.nodes.size(); ++i) {
    if (!is_free[window.nodes[i]]) continue;
    graph_.set_pose(window.nodes[i], window.graph.nodes()[i].T_world_node);
    moved_.push_back(window.nodes[i]);
  }
  for (std::size_t i = 0; i < window.edges.size(); ++i) {
    weights_[window.edges[i]] = summary.weights[i];
  }
  summary.weights = weights_;
  return summary;
}

}  // namespace cvo_slam
