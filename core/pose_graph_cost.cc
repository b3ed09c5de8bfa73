// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "cvo_slam/core/pose_graph.h"

namespace cvo_slam {
namespace {

double weighted_square(const Vector6& r, const Matrix6& information) {
  return r.dot(information * r);
}

}  // namespace

Vector6 between_residual(const SE3& T_world_a, const SE3& T_world_b, const SE3& T_a_b) {
  const SE3 estimate = T_world_a.inverse() * T_world_b;
  const SE3 turn(T_a_b.rotation() * estimate.rotation().transpose(), Vector3::Zero());
  Vector6 r;
  r << estimate.translation() - T_a_b.translation(), 2 * turn.quaternion().head<3>();
  return r;
}

double squared_error(const PoseGraph& graph, std::size_t edge) {
  const auto [from, to] = graph.ends()[edge];
  const PoseGraphEdge& e = graph.edges()[edge];
  return weighted_square(between_residual(graph.nodes()[from].T_world_node,
                                          graph.nodes()[to].T_world_node, e.T_from_to),
                         e.information);
}

double graph_cost(const PoseGraph& graph) {
  double sum = 0;
  for (std::size_t i = 0; i < graph.edges().size(); ++i) sum += squared_error(graph, i);
  return sum / 2;
}

double graph_chi2_g2o(const PoseGraph& graph) {
  double sum = 0;
  for (std::size_t i = 0; i < graph.edges().size(); ++i) {
    const auto [from, to] = graph.ends()[i];
    const PoseGraphEdge& edge = graph.edges()[i];
    const SE3 error = edge.T_from_to.inverse() * graph.nodes()[from].T_world_node.inverse() *
                      graph.nodes()[to].T_world_node;
    Vector6 e;
    e << error.translation(), error.quaternion().head<3>();
    sum += weighted_square(e, edge.information);
  }
  return sum;
}

Matrix6 square_root_of_information(const Matrix6& information) {
  const Eigen::LLT<AlignedMatrix6> cholesky(information);
  if (cholesky.info() == Eigen::Success) return cholesky.matrixU();
  const Eigen::SelfAdjointEigenSolver<AlignedMatrix6> eigen(information);
  return eigen.eigenvalues().cwiseMax(0).cwiseSqrt().asDiagonal() *
         eigen.eigenvectors().transpose();
}

namespace {

/// The derivative of an edge's residual by a right perturbation of its measurement. To first order
/// T exp([v; w]) moves the estimate by R v and rotates it by R w, both seen in the frame `from`.
/// The residual has the rotation of the measurement relative to that of the estimate: -R w.
Matrix6 residual_of_tangent(const SE3& T_from_to) {
  Matrix6 jacobian = Matrix6::Zero();
  jacobian.topLeftCorner<3, 3>() = T_from_to.rotation();
  jacobian.bottomRightCorner<3, 3>() = -T_from_to.rotation();
  return jacobian;
}

}  // namespace

Matrix6 edge_information(const SE3& T_from_to, const Matrix6& information) {
  const Matrix6 jacobian = residual_of_tangent(T_from_to);  // orthogonal
  return jacobian * information * jacobian.transpose();
}

Matrix6 measurement_information(const PoseGraphEdge& edge) {
  const Matrix6 jacobian = residual_of_tangent(edge.T_from_to);
  return jacobian.transpose() * edge.information * jacobian;
}

}  // namespace cvo_slam
