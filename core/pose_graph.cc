// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/core/pose_graph.h"

#include <algorithm>
#include <string>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include "cvo_slam/core/error.h"

namespace cvo_slam {
namespace {

/// Returns why a matrix cannot be an information (inverse covariance) matrix, as the end of a
/// sentence; an empty text if it can. It must be finite, symmetric and positive semi-definite, the
/// last two up to rounding.
std::string information_problem(const Matrix6& information) {
  if (!information.allFinite()) return "has values that are not finite numbers";
  // Sums in another order, or a file with ten digits, leave such differences.
  constexpr double kRounding = 1e-9;
  const double size = information.cwiseAbs().maxCoeff();
  if ((information - information.transpose()).cwiseAbs().maxCoeff() > kRounding * size) {
    return "is not symmetric";
  }
  // The factorisation is fifty times faster than the eigenvalues, and nearly always enough.
  if (Eigen::LLT<AlignedMatrix6>(information).info() == Eigen::Success) return {};
  const Eigen::SelfAdjointEigenSolver<AlignedMatrix6> eigen(information, Eigen::EigenvaluesOnly);
  if (eigen.eigenvalues().minCoeff() < -kRounding * size) return "has a negative eigenvalue";
  return {};
}

void check_edge(const PoseGraphEdge& edge) {
  const auto fail = [&](const std::string& problem) {
    throw DataError(fmt::format("edge {} -> {}: {}", edge.from, edge.to, problem));
  };
  if (edge.from == edge.to) fail("both ends are the same node; remove it");
  if (!edge.T_from_to.matrix().allFinite()) {
    fail("the measurement has values that are not finite numbers; repair or remove the edge");
  }
  const std::string problem = information_problem(edge.information);
  if (!problem.empty()) {
    fail(fmt::format("the information matrix {}; repair or remove the edge", problem));
  }
}

}  // namespace

void PoseGraph::add_node(const PoseGraphNode& node) {
  if (!node.T_world_node.matrix().allFinite()) {
    throw DataError(
        fmt::format("node {}: the pose has values that are not finite; repair it", node.id));
  }
  if (!index_.emplace(node.id, nodes_.size()).second) {
    throw DataError(fmt::format("node {} exists already; ids must be unique", node.id));
  }
  parent_.push_back(nodes_.size());
  fixed_count_.push_back(node.fixed ? 1 : 0);
  edges_of_node_.emplace_back();
  nodes_.push_back(node);
}

void PoseGraph::add_edge(const PoseGraphEdge& edge) {
  check_edge(edge);
  ends_.emplace_back(index_of(edge.from), index_of(edge.to));
  edges_.push_back(edge);
  link_edge(edges_.size() - 1);
}

void PoseGraph::remove_edge(std::size_t index) {
  if (index >= edges_.size()) {
    throw DataError(fmt::format("edge {} cannot be removed: there are {}", index, edges_.size()));
  }
  edges_.erase(edges_.begin() + static_cast<std::ptrdiff_t>(index));
  ends_.erase(ends_.begin() + static_cast<std::ptrdiff_t>(index));
  link_all_edges();
}

void PoseGraph::remove_node(std::size_t index) {
  if (index >= nodes_.size()) {
    throw DataError(fmt::format("node {} cannot be removed: there are {}", index, nodes_.size()));
  }
  std::erase_if(edges_, [id = nodes_[index].id](const PoseGraphEdge& edge) {
    return edge.from == id || edge.to == id;
  });
  index_.erase(nodes_[index].id);
  nodes_.erase(nodes_.begin() + static_cast<std::ptrdiff_t>(index));
  for (std::size_t i = index; i < nodes_.size(); ++i) index_[nodes_[i].id] = i;
  ends_.clear();
  for (const PoseGraphEdge& edge : edges_) {
    ends_.emplace_back(index_of(edge.from), index_of(edge.to));
  }
  link_all_edges();
}

/// Finds the edges of each node and the connected components anew.
void PoseGraph::link_all_edges() {
  parent_.resize(nodes_.size());
  fixed_count_.resize(nodes_.size());
  edges_of_node_.assign(nodes_.size(), {});
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    parent_[i] = i;
    fixed_count_[i] = nodes_[i].fixed ? 1 : 0;
  }
  for (std::size_t i = 0; i < edges_.size(); ++i) link_edge(i);
}

void PoseGraph::link_edge(std::size_t edge) {
  const auto [from, to] = ends_[edge];
  edges_of_node_[from].push_back(edge);
  edges_of_node_[to].push_back(edge);
  const auto [first, second] = std::minmax({find_root(from), find_root(to)});
  if (first == second) return;
  parent_[second] = first;
  fixed_count_[first] += fixed_count_[second];
}

std::size_t PoseGraph::find_root(std::size_t node) {
  while (parent_[node] != node) {
    parent_[node] = parent_[parent_[node]];  // halves the path for the next search
    node = parent_[node];
  }
  return node;
}

bool PoseGraph::has_edge(NodeId from, NodeId to) const {
  const std::pair ends(index_of(from), index_of(to));
  const auto& [a, b] = ends;
  const bool a_has_fewer = edges_of_node_[a].size() < edges_of_node_[b].size();
  const std::vector<std::size_t>& edges = edges_of_node_[a_has_fewer ? a : b];
  return std::any_of(edges.begin(), edges.end(),
                     [&](std::size_t edge) { return ends_[edge] == ends; });
}

std::size_t PoseGraph::index_of(NodeId id) const {
  const auto found = index_.find(id);
  if (found == index_.end()) {
    throw DataError(fmt::format("node {} is unknown; add it first", id));
  }
  return found->second;
}

void PoseGraph::set_pose(std::size_t index, const SE3& T_world_node) {
  nodes_.at(index).T_world_node = T_world_node;
}

void PoseGraph::set_fixed(std::size_t index, bool fixed) {
  if (nodes_.at(index).fixed == fixed) return;
  nodes_[index].fixed = fixed;
  std::size_t& count = fixed_count_[find_root(index)];
  count = fixed ? count + 1 : count - 1;
}

std::vector<std::size_t> PoseGraph::components() const {
  std::vector<std::size_t> component(nodes_.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    component[i] = parent_[i] == i ? count++ : component[parent_[i]];
  }
  return component;
}

bool PoseGraph::is_held(std::size_t index) const {
  const bool is_root = parent_.at(index) == index;
  return nodes_[index].fixed || (is_root && fixed_count_[index] == 0);
}

std::vector<bool> PoseGraph::held_nodes() const {
  std::vector<bool> held(nodes_.size());
  for (std::size_t i = 0; i < held.size(); ++i) held[i] = is_held(i);
  return held;
}

}  // namespace cvo_slam
