// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/backend/pose_graph_optimizer.h"

#include <tuple>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/bench/graph_samples.h"
#include "cvo_slam/core/error.h"

namespace cvo_slam {
namespace {

/// Feeds a graph node by node, each with the edges that end at it, optimising after each.
template <typename After>
void grow(PoseGraphOptimizer& optimizer, const PoseGraph& graph, const After& after_node) {
  for (std::size_t i = 0; i < graph.nodes().size(); ++i) {
    PoseGraphNode node = graph.nodes()[i];
    std::vector<PoseGraphEdge> edges;
    for (std::size_t e = 0; e < graph.edges().size(); ++e) {
      if (graph.ends()[e].second == i) edges.push_back(graph.edges()[e]);
    }
    if (!edges.empty()) {
      const auto& known = optimizer.graph();
      node.T_world_node =
          known.nodes()[known.index_of(edges[0].from)].T_world_node * edges[0].T_from_to;
    }
    optimizer.add_node(node);
    for (const PoseGraphEdge& edge : edges) optimizer.add_edge(edge);
    after_node();
  }
}

TEST(PoseGraphOptimizer, GrowsToTheOptimumOfTheWholeGraph) {
  const SampleGraph sample = make_rounds(20, 2);
  PoseGraphOptimizer optimizer({.window = 5});
  grow(optimizer, sample.graph, [&] { EXPECT_TRUE(optimizer.optimize().converged); });
  PoseGraph whole = sample.graph;
  const double optimum = optimize(whole).final_cost;
  const Summary last = optimizer.optimize(OptimizationScope::kFull);
  EXPECT_NEAR(last.final_cost, optimum, 1e-6 * optimum);
  // The windows alone have reduced most of the cost.
  EXPECT_LT(last.initial_cost, 1.5 * optimum);
}

TEST(PoseGraphOptimizer, AWindowMovesOnlyNearNodes) {
  const SampleGraph sample = make_rounds(20, 2);
  PoseGraphOptimizer optimizer({.window = 3});
  grow(optimizer, sample.graph, [] {});
  const PoseGraph before = optimizer.graph();
  optimizer.optimize();
  // Three edges from node 59: 56 to 58 by odometry, 38 to 40 and 18 to 20 by loops of 20 nodes.
  const std::vector<std::size_t> near = {19, 37, 38, 39, 40, 41, 56, 57, 58, 59, 18, 20};
  for (std::size_t i = 0; i < before.nodes().size(); ++i) {
    const bool moved = before.nodes()[i].T_world_node.matrix() !=
                       optimizer.graph().nodes()[i].T_world_node.matrix();
    EXPECT_EQ(moved, std::find(near.begin(), near.end(), i) != near.end()) << i;
  }
  EXPECT_THAT(optimizer.moved(), testing::UnorderedElementsAreArray(near));
  optimizer.optimize(OptimizationScope::kFull);
  EXPECT_EQ(optimizer.moved().size(), before.nodes().size());
}

TEST(PoseGraphOptimizer, StartsFromTheLastSolution) {
  const SampleGraph sample = make_rounds(20, 2);
  PoseGraphOptimizer optimizer;
  grow(optimizer, sample.graph, [] {});
  const Summary first = optimizer.optimize(OptimizationScope::kFull);
  const Summary again = optimizer.optimize(OptimizationScope::kFull);
  EXPECT_EQ(again.initial_cost, first.final_cost);
  EXPECT_LE(again.iterations, 1);
}

TEST(PoseGraphOptimizer, RejectedEdgesStayRejectedAndCanBeSeen) {
  const SampleGraph sample = make_rounds(20, 2);
  PoseGraphOptimizer optimizer({.loss = RobustLoss::kGnc, .loss_scale = 6, .window = 4});
  grow(optimizer, sample.graph, [&] { optimizer.optimize(); });
  PoseGraphEdge wrong{50, 5, SE3(), 1e4 * Matrix6::Identity(), EdgeKind::kLoop, true};
  optimizer.add_edge(wrong);
  const Summary full = optimizer.optimize(OptimizationScope::kFull);
  EXPECT_EQ(full.rejected_edges(), 1);
  EXPECT_EQ(optimizer.weights().back(), 0);
  optimizer.add_node({100, SE3()});
  optimizer.add_edge({59, 100, SE3()});
  const Summary window = optimizer.optimize();
  EXPECT_EQ(window.weights.size(), optimizer.graph().edges().size());
  EXPECT_EQ(window.rejected_edges(), 1);
}

TEST(PoseGraphOptimizer, ARemovedEdgeLeavesNothingBehind) {
  const SampleGraph sample = make_rounds(20, 2);
  PoseGraphOptimizer optimizer({.window = 4});
  PoseGraphOptimizer expected({.window = 4});
  grow(expected, sample.graph, [] {});
  for (const PoseGraphNode& node : expected.graph().nodes()) optimizer.add_node(node);
  // In the middle of the list, so that later edges get other indices.
  const auto& edges = expected.graph().edges();
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (i == 30) optimizer.add_edge({50, 5, SE3(), 1e4 * Matrix6::Identity(), EdgeKind::kLoop});
    optimizer.add_edge(edges[i]);
  }
  optimizer.remove_edge(30);
  EXPECT_EQ(optimizer.weights().size(), edges.size());
  for (const OptimizationScope scope : {OptimizationScope::kWindow, OptimizationScope::kFull}) {
    EXPECT_EQ(optimizer.optimize(scope).final_cost, expected.optimize(scope).final_cost);
  }
  EXPECT_THROW(optimizer.remove_edge(edges.size()), DataError);
}

TEST(PoseGraphOptimizer, ARemovedNodeTakesTheWeightsOfItsEdgesAlong) {
  PoseGraphOptimizer optimizer({.loss = RobustLoss::kCauchy});
  for (NodeId id = 0; id < 4; ++id) {
    optimizer.add_node({id, SE3(Matrix3::Identity(), {1.0 * static_cast<double>(id), 0, 0})});
  }
  const SE3 T_step(Matrix3::Identity(), {1, 0, 0});
  const SE3 T_wrong(Matrix3::Identity(), {9, 0, 0});
  const Matrix6 information = 1e4 * Matrix6::Identity();
  for (NodeId id = 0; id < 3; ++id) optimizer.add_edge({id, id + 1, T_step, information});
  optimizer.add_edge({0, 1, T_step, information});
  optimizer.add_edge({2, 3, T_wrong, 100 * Matrix6::Identity(), EdgeKind::kLoop, true});
  std::ignore = optimizer.optimize(OptimizationScope::kFull);
  const double weight_of_wrong = optimizer.weights().back();
  ASSERT_LT(weight_of_wrong, 0.5);
  optimizer.remove_node(1);  // with the edges 0, 1 and 3
  ASSERT_EQ(optimizer.weights().size(), 2U);
  EXPECT_EQ(optimizer.weights().back(), weight_of_wrong);
  EXPECT_TRUE(optimizer.moved().empty()) << "the indices have changed";
}

TEST(PoseGraphOptimizer, AnEmptyGraphIsOptimal) {
  PoseGraphOptimizer optimizer;
  EXPECT_TRUE(optimizer.optimize().converged);
  EXPECT_TRUE(optimizer.optimize(OptimizationScope::kFull).converged);
}

TEST(PoseGraphOptimizer, OptionsOutOfRangeAreErrors) {
  EXPECT_THROW(PoseGraphOptimizer({.window = 0}), OptionError);
}

}  // namespace
}  // namespace cvo_slam
