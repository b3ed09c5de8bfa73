// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/LU>
#include <gtest/gtest.h>

#include "cvo_slam/core/pose_graph.h"
#include "cvo_slam/slam/path_uncertainty_internal.h"

namespace cvo_slam {
namespace {

/// A motion like a camera's between keyframes.
SE3 step(double turn) {
  Vector6 tangent;
  tangent << 0.2, -0.1, 0.05, 0.1, turn, -0.2;
  return SE3::exp(tangent);
}

Matrix6 information_of(double translation, double rotation) {
  Matrix6 information = Matrix6::Zero();
  information.diagonal().head<3>().setConstant(1 / (translation * translation));
  information.diagonal().tail<3>().setConstant(1 / (rotation * rotation));
  information(0, 4) = information(4, 0) = 0.1 * information(0, 0);
  return information;
}

PoseGraph chain(int nodes) {
  PoseGraph graph;
  SE3 pose;
  for (int i = 0; i < nodes; ++i) {
    graph.add_node({i, pose});
    pose = pose * step(0.1 * i);
  }
  for (int i = 0; i + 1 < nodes; ++i) {
    graph.add_edge({i, i + 1, step(0.1 * i),
                    edge_information(step(0.1 * i), information_of(0.01 + 0.001 * i, 0.02))});
  }
  return graph;
}

/// The covariance of a right perturbation of T_a_b, from the dense inverse of the Gauss-Newton
/// Hessian with numeric derivatives, where node a is held.
Matrix6 marginal_covariance(const PoseGraph& graph, std::size_t a, std::size_t b) {
  constexpr double kStep = 1e-6;
  const auto size = static_cast<Eigen::Index>(6 * graph.nodes().size());
  Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(size, size);
  for (std::size_t e = 0; e < graph.edges().size(); ++e) {
    const PoseGraphEdge& edge = graph.edges()[e];
    const auto [from, to] = graph.ends()[e];
    const SE3& T_from = graph.nodes()[from].T_world_node;
    const SE3& T_to = graph.nodes()[to].T_world_node;
    Eigen::MatrixXd J = Eigen::MatrixXd::Zero(6, size);
    for (int k = 0; k < 6; ++k) {
      const SE3 plus = SE3::exp(kStep * Vector6::Unit(k));
      const SE3 minus = plus.inverse();
      J.col(static_cast<Eigen::Index>(6 * from) + k) =
          (between_residual(T_from * plus, T_to, edge.T_from_to) -
           between_residual(T_from * minus, T_to, edge.T_from_to)) /
          (2 * kStep);
      J.col(static_cast<Eigen::Index>(6 * to) + k) =
          (between_residual(T_from, T_to * plus, edge.T_from_to) -
           between_residual(T_from, T_to * minus, edge.T_from_to)) /
          (2 * kStep);
    }
    hessian += J.transpose() * edge.information * J;
  }
  const auto held = static_cast<Eigen::Index>(6 * a);
  hessian.middleRows(held, 6).setZero();
  hessian.middleCols(held, 6).setZero();
  hessian.block(held, held, 6, 6).setIdentity();
  if (a == b) return Matrix6::Zero();
  const auto block = static_cast<Eigen::Index>(6 * b);
  return hessian.inverse().block(block, block, 6, 6);
}

TEST(PathCovariances, OfAChainAreTheMarginalOnes) {
  const PoseGraph graph = chain(5);
  for (const std::size_t source : {0U, 4U, 2U}) {
    const auto covariances = path_covariances(graph, source);
    for (std::size_t i = 0; i < 5; ++i) {
      const Matrix6 expected = marginal_covariance(graph, source, i);
      ASSERT_TRUE(covariances[i].has_value());
      // Both are exact where the graph fits its measurements, apart from rounding.
      EXPECT_LT((*covariances[i] - expected).norm(), 1e-9) << source << " to " << i;
    }
  }
}

TEST(PathCovariances, TakeTheMoreCertainWay) {
  PoseGraph graph = chain(4);
  const SE3 direct = graph.nodes()[0].T_world_node.inverse() * graph.nodes()[3].T_world_node;
  const Matrix6 before = *path_covariances(graph, 0)[3];
  graph.add_edge({0, 3, direct, edge_information(direct, information_of(1, 1))});
  EXPECT_EQ(*path_covariances(graph, 0)[3], before);
  graph.add_edge({0, 3, direct, edge_information(direct, information_of(0.001, 0.001))});
  EXPECT_LT(path_covariances(graph, 0)[3]->trace(), 0.1 * before.trace());
}

TEST(PathCovariances, OfAnotherPartAreEmpty) {
  PoseGraph graph = chain(2);
  graph.add_node({7, SE3()});
  EXPECT_FALSE(path_covariances(graph, 0)[2].has_value());
}

}  // namespace
}  // namespace cvo_slam
