// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "cvo_slam/backend/marginal_covariances.h"
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

TEST(PathCovariances, OfAChainAreTheMarginalOnes) {
  const PoseGraph graph = chain(5);
  const MarginalCovariances marginal(graph);
  for (const std::size_t source : {0U, 4U, 2U}) {
    const auto covariances = path_covariances(graph, source);
    for (std::size_t i = 0; i < 5; ++i) {
      const Matrix6 expected =
          marginal.between(static_cast<NodeId>(source), static_cast<NodeId>(i));
      ASSERT_TRUE(covariances[i].has_value());
      // Both are exact where the graph fits its measurements: rounding only.
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
