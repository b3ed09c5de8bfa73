// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/backend/marginal_covariances.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "cvo_slam/backend/optimizer.h"
#include "cvo_slam/bench/graph_samples.h"
#include "cvo_slam/core/error.h"
#include "cvo_slam/core/pose_graph.h"

namespace cvo_slam {
namespace {

Matrix6 random_information(std::mt19937& rng) {
  Matrix6 root;
  for (int k = 0; k < 6; ++k) root.col(k) = random_tangent(rng, 10, 10);
  return root * root.transpose() + Matrix6::Identity();
}

/// One edge: the covariance of its end is the measurement's, which also proves edge_information().
TEST(MarginalCovariances, OfOneMeasurementAreItsOwn) {
  std::mt19937 rng(1);
  for (int i = 0; i < 10; ++i) {
    const SE3 T = SE3::exp(random_tangent(rng, 2, 1));
    const Matrix6 information = random_information(rng);
    PoseGraph graph;
    graph.add_node({0, SE3::exp(random_tangent(rng, 2, 1))});
    graph.add_node({1, graph.nodes()[0].T_world_node * T});
    graph.add_edge({0, 1, T, edge_information(T, information)});
    const MarginalCovariances covariances(graph);
    const Matrix6 expected = information.inverse();
    EXPECT_LT((covariances.of(1) - expected).norm(), 1e-9 * expected.norm());
    EXPECT_LT((covariances.between(0, 1) - expected).norm(), 1e-9 * expected.norm());
    EXPECT_EQ(covariances.of(0), Matrix6::Zero());
  }
}

/// Between two nodes only the path between them counts, not how they hang on the held one.
TEST(MarginalCovariances, BetweenNodesOfAChain) {
  std::mt19937 rng(2);
  PoseGraph graph;
  graph.add_node({0, SE3()});
  std::vector<Matrix6> information = {Matrix6::Identity()};
  for (int i = 1; i < 4; ++i) {
    const SE3 T = SE3::exp(random_tangent(rng, 2, 1));
    information.push_back(random_information(rng));
    graph.add_node({i, graph.nodes().back().T_world_node * T});
    graph.add_edge({i - 1, i, T, edge_information(T, information.back())});
  }
  const MarginalCovariances covariances(graph);
  const Matrix6 last = information[3].inverse();
  EXPECT_LT((covariances.between(2, 3) - last).norm(), 1e-8 * last.norm());
  // First-order propagation: T_13 = T_12 T_23.
  const Matrix6 Ad =
      (graph.nodes()[3].T_world_node.inverse() * graph.nodes()[2].T_world_node).adjoint();
  const Matrix6 two = Ad * information[2].inverse() * Ad.transpose() + last;
  EXPECT_LT((covariances.between(1, 3) - two).norm(), 1e-8 * two.norm());
}

/// Over many draws of the noise the normalised squared error of a node has mean 6.
TEST(MarginalCovariances, AreConsistentWithTheErrors) {
  constexpr int kDraws = 60;
  double sum = 0;
  for (unsigned seed = 0; seed < kDraws; ++seed) {
    SampleGraph sample = make_rounds(8, seed);
    optimize(sample.graph);
    const MarginalCovariances covariances(sample.graph);
    const Vector6 error =
        (sample.truth[12].inverse() * sample.graph.nodes()[12].T_world_node).log();
    sum += error.dot(covariances.of(12).inverse() * error);
  }
  // Chi-square of 360 degrees of freedom: standard deviation 26.8, four of them.
  EXPECT_NEAR(sum, 6 * kDraws, 108);
}

TEST(MarginalCovariances, WeightsScaleTheInformation) {
  SampleGraph sample = make_rounds(8, 1);
  std::vector<double> half(sample.graph.edges().size(), 0.5);
  const Matrix6 full = MarginalCovariances(sample.graph).of(5);
  EXPECT_LT((MarginalCovariances(sample.graph, half).of(5) - 2 * full).norm(), 1e-9 * full.norm());
}

TEST(MarginalCovariances, UndeterminedPosesAndUnknownNodesAreErrors) {
  PoseGraph graph;
  graph.add_node({0, SE3()});
  graph.add_node({1, SE3()});
  Matrix6 positions_only = Matrix6::Zero();
  positions_only.topLeftCorner<3, 3>().setIdentity();
  graph.add_edge({0, 1, SE3(), positions_only});
  EXPECT_THROW(MarginalCovariances{graph}, DataError);
  const SampleGraph sample = make_rounds(8, 1);
  EXPECT_THROW(static_cast<void>(MarginalCovariances(sample.graph).of(99)), DataError);
}

}  // namespace
}  // namespace cvo_slam
