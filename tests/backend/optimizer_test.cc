// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/backend/optimizer.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/bench/graph_samples.h"
#include "cvo_slam/core/error.h"
#include "cvo_slam/core/pose_graph.h"

namespace cvo_slam {
namespace {

TEST(Optimizer, FindsKnownPosesAndSaysHow) {
  SampleGraph sample = make_rounds(50, 3);
  const double drift = position_rmse(sample.graph, sample.truth);
  const double before = graph_cost(sample.graph);
  const Summary summary = optimize(sample.graph);
  EXPECT_TRUE(summary.converged);
  EXPECT_EQ(summary.initial_cost, before);
  EXPECT_EQ(summary.final_cost, graph_cost(sample.graph));
  EXPECT_EQ(summary.solves, 1);
  EXPECT_GT(summary.iterations, 0);
  EXPECT_NE(summary.reason, "");
  EXPECT_GT(summary.seconds, 0);
  EXPECT_THAT(summary.weights, testing::Each(1.0));
  EXPECT_EQ(summary.rejected_edges(), 0);
  EXPECT_LT(position_rmse(sample.graph, sample.truth), 0.5 * drift);
  // 249 edges of six values against 149 free nodes of six: chi-square of 600 degrees of freedom,
  // halved; five standard deviations are 87.
  EXPECT_NEAR(summary.final_cost, 300, 87);
}

TEST(Optimizer, FixedNodesStay) {
  SampleGraph sample = make_rounds(20, 3);
  sample.graph.set_fixed(30, true);
  const SE3 fixed = sample.graph.nodes()[30].T_world_node;
  const SE3 first = sample.graph.nodes()[0].T_world_node;
  optimize(sample.graph);
  EXPECT_EQ(sample.graph.nodes()[30].T_world_node.matrix(), fixed.matrix());
  EXPECT_NE(sample.graph.nodes()[0].T_world_node.matrix(), first.matrix());
}

/// Two components give the same poses as two separate graphs; the first node of each is held.
TEST(Optimizer, ComponentsAreOptimisedSeparately) {
  SampleGraph alone = make_rounds(10, 3);
  PoseGraph both = alone.graph;
  const SE3 elsewhere(so3_exp({0.3, 0, 1}), {100, 0, 0});
  for (const PoseGraphNode& node : alone.graph.nodes()) {
    both.add_node({node.id + 1000, elsewhere * node.T_world_node});
  }
  for (PoseGraphEdge edge : alone.graph.edges()) {
    edge.from += 1000;
    edge.to += 1000;
    both.add_edge(edge);
  }
  both.add_node({5000, elsewhere});  // a component of its own
  EXPECT_TRUE(optimize(both).converged);
  optimize(alone.graph);
  const std::size_t count = alone.graph.nodes().size();
  for (std::size_t i = 0; i < count; ++i) {
    const SE3 T = alone.graph.nodes()[i].T_world_node;
    // Two searches for one optimum, which end within the tolerance of the cost.
    EXPECT_LT((both.nodes()[i].T_world_node.matrix() - T.matrix()).norm(), 1e-5);
    EXPECT_LT((both.nodes()[count + i].T_world_node.matrix() - (elsewhere * T).matrix()).norm(),
              1e-5);
  }
  EXPECT_EQ(both.nodes().back().T_world_node.matrix(), elsewhere.matrix());
}

TEST(Optimizer, NothingToMoveIsConverged) {
  PoseGraph empty;
  EXPECT_TRUE(optimize(empty).converged);
  PoseGraph one;
  one.add_node({0, SE3()});
  const Summary summary = optimize(one, {.loss = RobustLoss::kGnc});
  EXPECT_TRUE(summary.converged);
  EXPECT_EQ(summary.reason, "nothing to move");
}

TEST(Optimizer, SaysWhenTheLimitOfIterationsEndsIt) {
  SampleGraph sample = make_rounds(50, 3);
  const Summary summary =
      optimize(sample.graph, {.initialization = Initialization::kGiven, .max_iterations = 1});
  EXPECT_FALSE(summary.converged);
  EXPECT_EQ(summary.iterations, 1);
}

TEST(Optimizer, OptionsOutOfRangeAreErrors) {
  PoseGraph graph;
  EXPECT_THROW(optimize(graph, {.loss_scale = 0}), OptionError);
  EXPECT_THROW(optimize(graph, {.max_iterations = 0}), OptionError);
  EXPECT_THROW(optimize(graph, {.cost_tolerance = std::numeric_limits<double>::quiet_NaN()}),
               OptionError);
}

/// Information without rotations: positions are found and rotations stay.
TEST(Optimizer, SemiDefiniteInformationIsEnough) {
  Matrix6 positions_only = Matrix6::Zero();
  positions_only.topLeftCorner<3, 3>().setIdentity();
  PoseGraph graph;
  graph.add_node({0, SE3()});
  graph.add_node({1, SE3()});
  graph.add_edge({0, 1, SE3(Matrix3::Identity(), {1, 2, 3}), positions_only});
  EXPECT_TRUE(optimize(graph).converged);
  EXPECT_LT((graph.nodes()[1].T_world_node.translation() - Vector3(1, 2, 3)).norm(), 1e-6);
  EXPECT_LT(graph.nodes()[1].T_world_node.angle(), 1e-6);
}

/// Two measurements of one distance, one of them robust and far off: the optimum in closed form.
double position_under(RobustLoss loss) {
  const auto at = [](double x) { return SE3(Matrix3::Identity(), {x, 0, 0}); };
  PoseGraph graph;
  graph.add_node({0, SE3()});
  graph.add_node({1, SE3()});
  graph.add_edge({0, 1, at(0)});
  PoseGraphEdge wrong{0, 1, at(10)};
  wrong.robust = true;
  graph.add_edge(wrong);
  optimize(graph, {.loss = loss, .loss_scale = 1, .cost_tolerance = 1e-12});
  return graph.nodes()[1].T_world_node.translation().x();
}

TEST(Optimizer, LossesAreForRobustEdges) {
  EXPECT_NEAR(position_under(RobustLoss::kNone), 5, 1e-5);
  EXPECT_NEAR(position_under(RobustLoss::kHuber), 1, 1e-5);  // x = c, the pull of the other
  // The least root of x (1 + (10 - x)^2) = 10 - x.
  const double x = position_under(RobustLoss::kCauchy);
  EXPECT_NEAR(x * (1 + (10 - x) * (10 - x)), 10 - x, 1e-4);
  EXPECT_LT(x, 1);
  EXPECT_NEAR(position_under(RobustLoss::kGnc), 0, 1e-5);
}

}  // namespace
}  // namespace cvo_slam
