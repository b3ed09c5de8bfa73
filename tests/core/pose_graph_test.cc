// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/core/pose_graph.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/core/error.h"

namespace cvo_slam {
namespace {

using testing::ElementsAre;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

SE3 at(double x) { return {Matrix3::Identity(), {x, 0, 0}}; }

PoseGraph nodes(int count) {
  PoseGraph graph;
  for (int id = 0; id < count; ++id) graph.add_node({id, at(id)});
  return graph;
}

template <typename F>
std::string error_of(const F& f) {
  try {
    f();
  } catch (const DataError& error) {
    return error.what();
  }
  return "no error";
}

TEST(PoseGraph, RefusesBadNodes) {
  PoseGraph graph = nodes(2);
  EXPECT_EQ(error_of([&] {
              graph.add_node({1, SE3()});
            }),
            "node 1 exists already; ids must be unique");
  EXPECT_EQ(error_of([&] {
              graph.add_node({2, at(kNan)});
            }),
            "node 2: the pose has values that are not finite; repair it");
  EXPECT_EQ(graph.nodes().size(), 2);
}

TEST(PoseGraph, RefusesBadEdges) {
  PoseGraph graph = nodes(2);
  const auto error_with = [&](const PoseGraphEdge& edge) {
    return error_of([&] { graph.add_edge(edge); });
  };
  EXPECT_EQ(error_with({0, 7, at(1)}), "node 7 is unknown; add it first");
  EXPECT_EQ(error_with({1, 1, at(1)}), "edge 1 -> 1: both ends are the same node; remove it");
  EXPECT_EQ(error_with({0, 1, at(kNan)}),
            "edge 0 -> 1: the measurement has values that are not finite numbers; repair or remove "
            "the edge");
  Matrix6 information = Matrix6::Identity();
  information(1, 2) = 0.5;
  EXPECT_EQ(error_with({0, 1, at(1), information}),
            "edge 0 -> 1: the information matrix is not symmetric; repair or remove the edge");
  information(2, 1) = 0.5;
  EXPECT_EQ(error_with({0, 1, at(1), information}), "no error");
  information(1, 2) = information(2, 1) = 2;
  EXPECT_EQ(
      error_with({0, 1, at(1), information}),
      "edge 0 -> 1: the information matrix has a negative eigenvalue; repair or remove the edge");
  information(3, 3) = kNan;
  EXPECT_EQ(error_with({0, 1, at(1), information}),
            "edge 0 -> 1: the information matrix has values that are not finite numbers; repair or "
            "remove the edge");
  EXPECT_EQ(graph.edges().size(), 1);
}

TEST(PoseGraph, RemovesEdges) {
  PoseGraph graph = nodes(3);
  graph.add_edge({0, 1, at(1)});
  graph.add_edge({1, 2, at(1)});
  graph.remove_edge(0);
  ASSERT_EQ(graph.edges().size(), 1);
  EXPECT_EQ(graph.edges()[0].to, 2);
  EXPECT_THAT(graph.ends(), ElementsAre(std::pair<std::size_t, std::size_t>(1, 2)));
  EXPECT_EQ(error_of([&] { graph.remove_edge(1); }), "edge 1 cannot be removed: there are 1");
}

TEST(PoseGraph, RemovesNodesWithTheirEdges) {
  PoseGraph graph = nodes(4);
  graph.add_edge({0, 1, at(1)});
  graph.add_edge({1, 2, at(1)});
  graph.add_edge({2, 3, at(1)});
  graph.add_edge({3, 0, at(-3)});
  graph.remove_node(1);
  ASSERT_EQ(graph.nodes().size(), 3U);
  EXPECT_FALSE(graph.has_node(1));
  EXPECT_EQ(graph.index_of(3), 2U);
  using Ends = std::pair<std::size_t, std::size_t>;
  EXPECT_THAT(graph.ends(), ElementsAre(Ends(1, 2), Ends(2, 0)));
  EXPECT_THAT(graph.edges_of(2), ElementsAre(0, 1));
  EXPECT_THAT(graph.components(), ElementsAre(0, 0, 0));
  graph.add_node({1, at(5)});  // its id is free again
  EXPECT_THAT(graph.held_nodes(), ElementsAre(true, false, false, true));
  EXPECT_EQ(error_of([&] { graph.remove_node(4); }), "node 4 cannot be removed: there are 4");
}

TEST(PoseGraph, KnowsTheEdgesOfANode) {
  PoseGraph graph = nodes(4);
  graph.add_edge({0, 1, at(1)});
  graph.add_edge({2, 1, at(-1)});
  graph.add_edge({0, 2, at(2)});
  EXPECT_THAT(graph.edges_of(1), ElementsAre(0, 1));
  EXPECT_TRUE(graph.edges_of(3).empty());
  EXPECT_TRUE(graph.has_edge(2, 1));
  EXPECT_FALSE(graph.has_edge(1, 2));
  EXPECT_FALSE(graph.has_edge(1, 3));
  EXPECT_EQ(error_of([&] { static_cast<void>(graph.has_edge(1, 7)); }),
            "node 7 is unknown; add it first");
  graph.remove_edge(0);
  EXPECT_THAT(graph.edges_of(0), ElementsAre(1));
  EXPECT_THAT(graph.edges_of(1), ElementsAre(0));
  EXPECT_THAT(graph.edges_of(2), ElementsAre(0, 1));
  EXPECT_FALSE(graph.has_edge(0, 1));
}

TEST(PoseGraph, KnowsItsConnectedComponents) {
  PoseGraph graph = nodes(6);
  graph.add_edge({5, 1, at(1)});
  graph.add_edge({3, 5, at(1)});
  graph.add_edge({4, 0, at(1)});
  EXPECT_THAT(graph.components(), ElementsAre(0, 1, 2, 1, 0, 1));
  graph.remove_edge(0);
  EXPECT_THAT(graph.components(), ElementsAre(0, 1, 2, 3, 0, 3));
}

TEST(PoseGraph, HoldsTheFixedNodesOrTheFirstOfAComponent) {
  PoseGraph graph = nodes(5);
  graph.add_edge({0, 1, at(1)});
  graph.add_edge({2, 3, at(1)});
  EXPECT_THAT(graph.held_nodes(), ElementsAre(true, false, true, false, true));
  graph.set_fixed(graph.index_of(3), true);
  EXPECT_THAT(graph.held_nodes(), ElementsAre(true, false, false, true, true));
  graph.add_edge({1, 2, at(1)});
  EXPECT_THAT(graph.held_nodes(), ElementsAre(false, false, false, true, true));
  graph.set_fixed(graph.index_of(3), false);
  EXPECT_THAT(graph.held_nodes(), ElementsAre(true, false, false, false, true));
  graph.remove_edge(2);
  EXPECT_THAT(graph.held_nodes(), ElementsAre(true, false, true, false, true));
}

TEST(PoseGraph, IdsNeedNotCountFromZero) {
  PoseGraph graph;
  graph.add_node({1000000000000, SE3()});
  graph.add_node({-4, SE3()});
  graph.add_edge({-4, 1000000000000, SE3()});
  EXPECT_EQ(graph.ends()[0], std::make_pair(std::size_t{1}, std::size_t{0}));
  EXPECT_EQ(error_of([&] { static_cast<void>(graph.index_of(0)); }),
            "node 0 is unknown; add it first");
}

TEST(PoseGraphCost, ResidualIsTheDocumentedFormula) {
  const SE3 a(so3_exp({0, 0, std::numbers::pi / 2}), {1, 0, 0});
  const SE3 b(so3_exp({0, 0, std::numbers::pi / 2 + 0.2}), {1, 2, 0});
  // Seen from a, b is 2 m ahead and turned by 0.2 rad; measured are 1.5 m and 0.5 rad.
  const SE3 T_a_b(so3_exp({0, 0, 0.5}), {1.5, 0, 0});
  const Vector6 r = between_residual(a, b, T_a_b);
  const Vector6 expected = (Vector6() << 0.5, 0, 0, 0, 0, 2 * std::sin(0.15)).finished();
  EXPECT_LT((r - expected).norm(), 1e-14);
}

TEST(PoseGraphCost, TheTwoConventions) {
  PoseGraph graph;
  graph.add_node({0, SE3()});
  graph.add_node({1, SE3(so3_exp({0, 0, 0.2}), {2, 0, 0})});
  Matrix6 information = Matrix6::Identity();
  information(5, 5) = 100;
  graph.add_edge({0, 1, at(1), information});
  // 1 m and 0.2 rad: r = [1, 0, 0, 0, 0, -2 sin 0.1], g2o's e = [1, 0, 0, 0, 0, sin 0.1].
  const double s = std::sin(0.1);
  EXPECT_NEAR(squared_error(graph, 0), 1 + 400 * s * s, 1e-12);
  EXPECT_NEAR(graph_cost(graph), 0.5 * (1 + 400 * s * s), 1e-12);
  EXPECT_NEAR(graph_chi2_g2o(graph), 1 + 100 * s * s, 1e-12);
}

TEST(Information, SquareRootsGiveTheMatrixBack) {
  Matrix6 root = Matrix6::Random();
  for (int rank = 6; rank >= 0; --rank) {
    const Matrix6 information = root.topRows(rank).transpose() * root.topRows(rank);
    PoseGraph graph = nodes(2);
    ASSERT_NO_THROW(graph.add_edge({0, 1, SE3(), information})) << rank;
    const Matrix6 S = square_root_of_information(information);
    EXPECT_LT((S.transpose() * S - information).norm(), 1e-12) << rank;
  }
}

/// The squared error of small perturbations of the measurement is the same for both matrices.
TEST(Information, OfAPerturbationIsThatOfTheResidual) {
  const SE3 T = SE3::exp((Vector6() << 1, -2, 0.5, 0.7, -0.3, 1.1).finished());
  const Matrix6 root = Matrix6::Random();
  const Matrix6 information = root * root.transpose();
  const Matrix6 of_residual = edge_information(T, information);
  constexpr double kStep = 1e-5;
  for (int i = 0; i < 20; ++i) {
    const Vector6 xi = kStep * Vector6::Random();
    const Vector6 r = between_residual(SE3(), T * SE3::exp(xi), T);
    const double expected = xi.dot(information * xi);
    EXPECT_NEAR(r.dot(of_residual * r), expected, 1e-4 * expected + 1e-16);
  }
}

}  // namespace
}  // namespace cvo_slam
