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

/// The number of a node, chosen by the caller; numbers need not count from 0.
using NodeId = std::int64_t;

/// A pose that optimisation estimates: that of a keyframe.
struct PoseGraphNode {
  NodeId id = 0;       ///< no other node of the graph has it
  SE3 T_world_node;    ///< where optimisation starts, and later its result
  bool fixed = false;  ///< true if optimisation must not move the node
};

/// How the pair of nodes of an edge was found. Optimisation does not depend on it.
enum class EdgeKind {
  kOdometry,   ///< between consecutive keyframes, or those that stand in for them
  kProximity,  ///< between keyframes that are near one another in the graph
  kLoop,       ///< to a keyframe found by place recognition
};

/// A measurement of one node's pose relative to another's.
struct PoseGraphEdge {
  NodeId from = 0;  ///< id of the node in whose frame the measurement is
  NodeId to = 0;    ///< id of the node whose pose was measured
  SE3 T_from_to;    ///< the measured pose
  /// Inverse covariance of between_residual() [1/m^2, 1/(m rad), 1/rad^2]; symmetric and positive
  /// semi-definite. edge_information() computes it from that of a right perturbation.
  Matrix6 information = Matrix6::Identity();
  EdgeKind kind = EdgeKind::kOdometry;  ///< how the pair of nodes was found
  /// True if the measurement may be an outlier. The robust loss applies to these edges only.
  bool robust = false;
};

/// Poses and measurements between them: a value that can be copied. Nodes and edges keep the order
/// in which they were added; there may be several edges between two nodes. Adding a node or an
/// edge, looking up a node and listing its edges do not take longer in a larger graph.
class PoseGraph {
 public:
  /// Throws DataError if the id is taken or the pose has values that are not finite.
  void add_node(const PoseGraphNode& node);
  /// Throws DataError if an end is unknown, both ends are the same node, the measurement has values
  /// that are not finite, or the information matrix is not symmetric and positive semi-definite.
  void add_edge(const PoseGraphEdge& edge);
  /// Removes the edge at an index of edges(); the indices of later edges decrease by one. Takes
  /// time in proportion to the graph. Throws DataError if there is no such edge.
  void remove_edge(std::size_t index);
  /// Removes the node at an index of nodes() with its edges; the indices of later nodes and edges
  /// decrease. Takes time in proportion to the graph. Throws DataError if there is no such node.
  void remove_node(std::size_t index);

  /// Returns the nodes in the order in which they were added.
  [[nodiscard]] const std::vector<PoseGraphNode>& nodes() const { return nodes_; }
  /// Returns the edges in the order in which they were added.
  [[nodiscard]] const std::vector<PoseGraphEdge>& edges() const { return edges_; }
  /// Indices in nodes() of the two ends (from, to) of each edge.
  [[nodiscard]] const std::vector<std::pair<std::size_t, std::size_t>>& ends() const {
    return ends_;
  }
  /// Indices in edges() of the edges of the node at an index of nodes(), in ascending order.
  [[nodiscard]] const std::vector<std::size_t>& edges_of(std::size_t node) const {
    return edges_of_node_.at(node);
  }

  /// Index in nodes() of the end of an edge that is not this node, which is one of its ends.
  [[nodiscard]] std::size_t other_end(std::size_t edge, std::size_t node) const {
    const auto& [from, to] = ends_.at(edge);
    return from == node ? to : from;
  }

  /// Returns true if a node has this id.
  [[nodiscard]] bool has_node(NodeId id) const { return index_.contains(id); }
  /// Returns true if an edge leads from one node to the other. Takes time in proportion to the
  /// edges of one of them. Throws DataError if a node is unknown.
  [[nodiscard]] bool has_edge(NodeId from, NodeId to) const;
  /// Returns the node's index in nodes(). Throws DataError if there is no such node.
  [[nodiscard]] std::size_t index_of(NodeId id) const;
  /// Replaces the pose of the node at an index of nodes().
  void set_pose(std::size_t index, const SE3& T_world_node);
  /// Fixes or releases the node at an index of nodes().
  void set_fixed(std::size_t index, bool fixed);

  /// Returns for each node the number of its connected component; components are numbered from 0
  /// in the order of their first nodes. Takes time in proportion to the nodes.
  [[nodiscard]] std::vector<std::size_t> components() const;
  /// Returns true if optimisation holds the node at an index of nodes(): the fixed nodes and the
  /// first node of each connected component without a fixed one. Measurements between poses do not
  /// say where a component as a whole is, so a separate component is optimised in itself and stays
  /// where it was.
  [[nodiscard]] bool is_held(std::size_t index) const;
  /// Returns is_held() of all nodes.
  [[nodiscard]] std::vector<bool> held_nodes() const;

 private:
  [[nodiscard]] std::size_t find_root(std::size_t node);
  void link_edge(std::size_t edge);
  void link_all_edges();

  std::vector<PoseGraphNode> nodes_;
  std::vector<PoseGraphEdge> edges_;
  std::vector<std::pair<std::size_t, std::size_t>> ends_;
  std::vector<std::vector<std::size_t>> edges_of_node_;
  std::unordered_map<NodeId, std::size_t> index_;
  // The connected components as disjoint-set trees: a parent comes before its child, so that the
  // first node of a component is its root.
  std::vector<std::size_t> parent_;
  std::vector<std::size_t> fixed_count_;  // fixed nodes of the component, at its root
};

/// Returns the residual of a measurement T_ab, which the back-end minimises:
///
///     r = [ R_a^T (p_b - p_a) - p_ab ; 2 vec(q_ab q_est^-1) ],   q_est = q_a^-1 q_b
///
/// [m; rad for small angles: 2 sin(angle / 2)], both parts in frame a. Products are Hamilton's, and
/// the quaternion of the rotation q_ab q_est^-1 is the one with w >= 0. This is the residual of
/// Ceres' own pose-graph example, for which optima are published.
[[nodiscard]] Vector6 between_residual(const SE3& T_world_a, const SE3& T_world_b,
                                       const SE3& T_a_b);

/// Returns r^T information r of the edge at an index of edges().
[[nodiscard]] double squared_error(const PoseGraph& graph, std::size_t edge);

/// Returns half the sum of the edges' squared errors: the cost in Ceres' convention.
[[nodiscard]] double graph_cost(const PoseGraph& graph);

/// Returns chi2 as the program g2o prints it: the sum (not half of it) of e^T information e with
/// e = [p ; vec(q)] of the pose T_ab^-1 T_a^-1 T_b, w >= 0 (R. Kuemmerle et al., "g2o: A General
/// Framework for Graph Optimization", ICRA 2011). It has half the angle where between_residual()
/// has the angle.
[[nodiscard]] double graph_chi2_g2o(const PoseGraph& graph);

/// Returns the information of an edge's between_residual() from the information of a right
/// perturbation of its measurement, T_from_to exp(xi), which is what registration returns.
[[nodiscard]] Matrix6 edge_information(const SE3& T_from_to, const Matrix6& information);

/// Returns the information of a right perturbation of an edge's measurement: the inverse of
/// edge_information().
[[nodiscard]] Matrix6 measurement_information(const PoseGraphEdge& edge);

/// Returns S with S^T S = information, so that |S r|^2 = r^T information r. S is upper triangular
/// if the matrix is positive definite. `information` must be valid for an edge.
[[nodiscard]] Matrix6 square_root_of_information(const Matrix6& information);

}  // namespace cvo_slam
