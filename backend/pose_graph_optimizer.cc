// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/backend/pose_graph_optimizer.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/saved_state.h"

namespace cvo_slam {
namespace {

/// The edges of the free nodes, with their ends, of which those that are not free are fixed.
struct Window {
  PoseGraph graph;
  std::vector<std::size_t> nodes;  // their indices in the whole graph
  std::vector<std::size_t> edges;  // their indices in the whole graph, ascending
};

Window make_window(const PoseGraph& graph, const std::unordered_set<std::size_t>& free_nodes) {
  Window window;
  for (const std::size_t node : free_nodes) {
    const std::vector<std::size_t>& edges = graph.edges_of(node);
    window.edges.insert(window.edges.end(), edges.begin(), edges.end());
  }
  std::sort(window.edges.begin(), window.edges.end());
  window.edges.erase(std::unique(window.edges.begin(), window.edges.end()), window.edges.end());
  for (const std::size_t edge : window.edges) {
    const auto [from, to] = graph.ends()[edge];
    for (const std::size_t end : {from, to}) {
      PoseGraphNode node = graph.nodes()[end];
      if (window.graph.has_node(node.id)) continue;
      node.fixed = !free_nodes.contains(end);
      window.graph.add_node(node);
      window.nodes.push_back(end);
    }
    window.graph.add_edge(graph.edges()[edge]);
  }
  return window;
}

}  // namespace

// SavedState finds these by their arguments, which it would not in a namespace without a name.
static void exchange(SavedState& state, PoseGraphNode& node) {
  state(node.id, node.T_world_node, node.fixed);
}

static void exchange(SavedState& state, PoseGraphEdge& edge) {
  state(edge.from, edge.to, edge.T_from_to, edge.information, edge.kind, edge.robust);
}

PoseGraphOptimizer::PoseGraphOptimizer(const OptimizerOptions& options) : options_(options) {
  describe(options_).check();
}

void PoseGraphOptimizer::add_edge(const PoseGraphEdge& edge) {
  graph_.add_edge(edge);
  weights_.push_back(1);
}

void PoseGraphOptimizer::remove_edge(std::size_t index) {
  graph_.remove_edge(index);
  weights_.erase(weights_.begin() + static_cast<std::ptrdiff_t>(index));
}

void PoseGraphOptimizer::remove_node(std::size_t index) {
  const std::vector<std::size_t> edges = graph_.edges_of(index);
  std::for_each(edges.rbegin(), edges.rend(), [this](std::size_t edge) {
    weights_.erase(weights_.begin() + static_cast<std::ptrdiff_t>(edge));
  });
  graph_.remove_node(index);
  moved_.clear();
}

Summary PoseGraphOptimizer::optimize(OptimizationScope scope) {
  if (scope == OptimizationScope::kWindow) return optimize_window();
  Summary summary = cvo_slam::optimize(graph_, options_);
  moved_.resize(graph_.nodes().size());
  std::iota(moved_.begin(), moved_.end(), std::size_t{0});
  weights_ = summary.weights;
  return summary;
}

void PoseGraphOptimizer::exchange(SavedState& state) {
  std::vector<PoseGraphNode> nodes = graph_.nodes();
  std::vector<PoseGraphEdge> edges = graph_.edges();
  state(nodes, edges, weights_);
  if (!state.is_reading()) return;
  graph_ = PoseGraph();
  for (const PoseGraphNode& node : nodes) graph_.add_node(node);
  for (const PoseGraphEdge& edge : edges) {
    if (edge.kind > EdgeKind::kLoop || edge.kind < EdgeKind::kOdometry) {
      throw DataError("a saved state has an edge of no known kind");
    }
    graph_.add_edge(edge);
  }
  if (weights_.size() != edges.size()) throw DataError("a saved state has edges without weights");
  moved_.clear();
}

std::unordered_set<std::size_t> PoseGraphOptimizer::free_nodes_near_newest() const {
  if (graph_.nodes().empty()) return {};
  std::vector<std::size_t> ring = {graph_.nodes().size() - 1};
  std::unordered_set<std::size_t> near(ring.begin(), ring.end());
  for (int distance = 0; distance < options_.window && !ring.empty(); ++distance) {
    std::vector<std::size_t> next;
    for (const std::size_t node : ring) {
      for (const std::size_t edge : graph_.edges_of(node)) {
        if (weights_[edge] < 0.5) continue;  // a rejected edge leads nowhere
        const std::size_t other = graph_.other_end(edge, node);
        if (near.insert(other).second) next.push_back(other);
      }
    }
    ring = std::move(next);
  }
  std::erase_if(near, [&](std::size_t node) { return graph_.is_held(node); });
  return near;
}

Summary PoseGraphOptimizer::optimize_window() {
  const std::unordered_set<std::size_t> free_nodes = free_nodes_near_newest();
  Window window = make_window(graph_, free_nodes);
  OptimizerOptions options = options_;
  options.initialization = Initialization::kGiven;
  Summary summary = cvo_slam::optimize(window.graph, options);
  moved_.clear();
  for (std::size_t i = 0; i < window.nodes.size(); ++i) {
    if (!free_nodes.contains(window.nodes[i])) continue;
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
