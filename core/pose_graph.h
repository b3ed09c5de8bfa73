// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "cvo_slam/core/se3.h"

namespace cvo_slam {

/// The name of a node, chosen by whoever adds it; need not count from 0.
using NodeId = std::int64_t;

struct PoseGraphNode {
  NodeId id = 0;
  SE3 T_world_node;
  bool fixed = false;  ///< optimisation must not move it
};

enum class EdgeKind {
  kOdometry,   ///< of consecutive keyframes
  kProximity,  ///< of keyframes that are near one another in the graph
  kLoop,       ///< of a place that was recognised
};

/// A measurement of one node's pose relative to another's.
struct PoseGraphEdge {
  NodeId from = 0;
  NodeId to = 0;
  SE3 T_from_to;
  /// Inverse covariance of the residual of pose_graph_cost.h [1/m^2, 1/(m rad), 1/rad^2];
  /// symmetric, positive semi-definite. From a registration's answer: edge_information()
  /// (information.h).
  Matrix6 information = Matrix6::Identity();
  EdgeKind kind = EdgeKind::kOdometry;
  bool robust = false;  ///< may be wrong altogether: a robust loss is for such edges alone
};

/// Poses and measurements between them: a value that can be copied. Nodes and edges keep the order
/// in which they were added; there may be several edges between two nodes.
class PoseGraph {
 public:
  /// Throws DataError where the id is taken or the pose has values that are not finite.
  void add_node(const PoseGraphNode& node);
  /// Throws DataError where an end is unknown, both ends are the same node, the measurement has
  /// values that are not finite, or the information matrix is no such.
  void add_edge(const PoseGraphEdge& edge);
  /// Takes the index in edges(); those of later edges become one less. Throws DataError where there
  /// is no such edge.
  void remove_edge(std::size_t index);

  [[nodiscard]] const std::vector<PoseGraphNode>& nodes() const { return nodes_; }
  [[nodiscard]] const std::vector<PoseGraphEdge>& edges() const { return edges_; }
  /// Indices in nodes() of an edge's ends (from, to), for each of edges().
  [[nodiscard]] const std::vector<std::pair<std::size_t, std::size_t>>& ends() const {
    return ends_;
  }

  /// Indices in edges() of the edges that a node is an end of, ascending; takes the node's index in
  /// nodes().
  [[nodiscard]] const std::vector<std::size_t>& edges_of(std::size_t index) const {
    return edges_of_[index];
  }
  /// True if an edge leads from one node to the other. Throws DataError if there is no such node.
  [[nodiscard]] bool has_edge(NodeId from, NodeId to) const;

  [[nodiscard]] bool has_node(NodeId id) const { return index_.contains(id); }
  /// The node's place in nodes(); throws DataError where there is no such node.
  [[nodiscard]] std::size_t index_of(NodeId id) const;
  /// These take the index in nodes().
  void set_pose(std::size_t index, const SE3& T_world_node);
  void set_fixed(std::size_t index, bool fixed);

  /// For each node the number of its connected part; parts are numbered in the order of their
  /// first nodes, from 0.
  [[nodiscard]] std::vector<std::size_t> components() const;
  /// The nodes that optimisation holds: the fixed ones and, of each connected part that has none,
  /// the first, because measurements between poses say nothing of where the part is as a whole. So
  /// a part that hangs together with no other is optimised for itself and stays where it was.
  [[nodiscard]] std::vector<bool> held_nodes() const;

 private:
  std::vector<PoseGraphNode> nodes_;
  std::vector<PoseGraphEdge> edges_;
  std::vector<std::pair<std::size_t, std::size_t>> ends_;
  std::vector<std::vector<std::size_t>> edges_of_;  // by node
  std::unordered_map<NodeId, std::size_t> index_;
};

}  // namespace cvo_slam
