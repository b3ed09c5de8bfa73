// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/core/pose_graph.h"

#include <algorithm>
#include <numeric>
#include <string>

#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/information.h"

namespace cvo_slam {
namespace {

constexpr auto kUnlabelled = static_cast<std::size_t>(-1);

void check_edge(const PoseGraphEdge& edge) {
  const auto fail = [&](const std::string& problem) {
    throw DataError(fmt::format("edge {} -> {}: {}", edge.from, edge.to, problem));
  };
  if (edge.from == edge.to) fail("both ends are the same node; remove it");
  if (!edge.T_from_to.matrix().allFinite()) {
    fail("the measurement has values that are not finite numbers");
  }
  const std::string problem = information_problem(edge.information);
  if (!problem.empty()) fail(fmt::format("the information matrix {}", problem));
}

/// The root of a node's tree; paths are halved on the way.
std::size_t find_root(std::vector<std::size_t>& parent, std::size_t node) {
  while (parent[node] != node) {
    parent[node] = parent[parent[node]];
    node = parent[node];
  }
  return node;
}

}  // namespace

void PoseGraph::add_node(const PoseGraphNode& node) {
  if (!node.T_world_node.matrix().allFinite()) {
    throw DataError(fmt::format("node {}: the pose has values that are not finite", node.id));
  }
  if (!index_.emplace(node.id, nodes_.size()).second) {
    throw DataError(fmt::format("node {} exists already; ids must be unique", node.id));
  }
  nodes_.push_back(node);
  edges_of_.emplace_back();
}

void PoseGraph::add_edge(const PoseGraphEdge& edge) {
  check_edge(edge);
  const std::size_t from = index_of(edge.from);
  const std::size_t to = index_of(edge.to);
  edges_of_[from].push_back(edges_.size());
  edges_of_[to].push_back(edges_.size());
  ends_.emplace_back(from, to);
  edges_.push_back(edge);
}

void PoseGraph::remove_edge(std::size_t index) {
  if (index >= edges_.size()) {
    throw DataError(fmt::format("edge {} cannot be removed: there are {}", index, edges_.size()));
  }
  edges_.erase(edges_.begin() + static_cast<std::ptrdiff_t>(index));
  ends_.erase(ends_.begin() + static_cast<std::ptrdiff_t>(index));
  for (std::vector<std::size_t>& edges : edges_of_) {
    std::erase(edges, index);
    for (std::size_t& edge : edges) edge -= edge > index ? 1 : 0;
  }
}

bool PoseGraph::has_edge(NodeId from, NodeId to) const {
  const std::size_t a = index_of(from);
  const std::size_t b = index_of(to);
  return std::any_of(edges_of_[b].begin(), edges_of_[b].end(), [&](std::size_t edge) {
    return ends_[edge] == std::make_pair(a, b);
  });
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

void PoseGraph::set_fixed(std::size_t index, bool fixed) { nodes_.at(index).fixed = fixed; }

std::vector<std::size_t> PoseGraph::components() const {
  std::vector<std::size_t> parent(nodes_.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  for (const auto& [from, to] : ends_) {
    const std::size_t a = find_root(parent, from);
    const std::size_t b = find_root(parent, to);
    parent[std::max(a, b)] = std::min(a, b);
  }
  // A root is the first node of its part, so that it is labelled before the others.
  std::vector<std::size_t> label(nodes_.size(), kUnlabelled);
  std::size_t count = 0;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const std::size_t root = find_root(parent, i);
    label[i] = root == i ? count++ : label[root];
  }
  return label;
}

std::vector<bool> PoseGraph::held_nodes() const {
  const std::vector<std::size_t> part = components();
  std::vector<bool> part_is_held(nodes_.size());
  std::vector<bool> held(nodes_.size());
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (nodes_[i].fixed) held[i] = part_is_held[part[i]] = true;
  }
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (!part_is_held[part[i]]) held[i] = part_is_held[part[i]] = true;
  }
  return held;
}

}  // namespace cvo_slam
