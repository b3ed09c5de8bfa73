// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/backend/gnc_internal.h"
#include "cvo_slam/bench/graph_samples.h"

namespace cvo_slam {
namespace {

TEST(Gnc, WeightsGrowFromEqualToZeroOrOne) {
  constexpr double kC2 = 16;
  // Nearly convex: even the largest error, from which mu follows, keeps a weight, and half of that
  // error (a quarter of its square) has a weight that is at most five times larger. The formula
  // gives 4.4.
  const double mu_first = kC2 / (2 * 1e4 - kC2);
  EXPECT_GT(gnc_weight(1e4, kC2, mu_first), 0);
  EXPECT_NEAR(gnc_weight(1e4 / 4, kC2, mu_first) / gnc_weight(1e4, kC2, mu_first), 4.4, 0.1);
  // Large mu: nearly the truncated loss itself.
  EXPECT_EQ(gnc_weight(kC2 * 0.99, kC2, 1e3), 1);
  EXPECT_EQ(gnc_weight(kC2 * 1.01, kC2, 1e3), 0);
  // The weight is continuous where its pieces meet.
  for (const double mu : {0.01, 1.0, 50.0}) {
    EXPECT_NEAR(gnc_weight(mu / (mu + 1) * kC2 * (1 + 1e-9), kC2, mu), 1, 1e-6);
    EXPECT_NEAR(gnc_weight((mu + 1) / mu * kC2 * (1 - 1e-9), kC2, mu), 0, 1e-6);
  }
}

class FalseLoops : public testing::TestWithParam<double> {};

/// The error of the poses stays within 10 % of that without false loops.
TEST_P(FalseLoops, DoNotMoveThePoses) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    SampleGraph clean = make_rounds(60, seed);
    PoseGraph spoilt = clean.graph;
    add_false_loops(spoilt, GetParam(), seed);
    const std::size_t genuine = clean.graph.edges().size();
    optimize(clean.graph);
    const Summary summary = optimize(spoilt, {.loss = RobustLoss::kGnc});
    EXPECT_TRUE(summary.converged) << summary.reason;
    EXPECT_LT(position_rmse(spoilt, clean.truth), 1.1 * position_rmse(clean.graph, clean.truth));
    for (std::size_t i = genuine; i < spoilt.edges().size(); ++i) {
      EXPECT_EQ(summary.weights[i], 0) << "false loop " << i - genuine << ", seed " << seed;
    }
    // One in a hundred of the 120 genuine loops lies outside of 99 %: four are three sigma.
    EXPECT_LE(summary.rejected_edges() - (spoilt.edges().size() - genuine), 4);
  }
}

TEST_P(FalseLoops, WouldMoveThePosesWithoutGnc) {
  SampleGraph sample = make_rounds(60, 1);
  add_false_loops(sample.graph, GetParam(), 1);
  optimize(sample.graph, {.max_iterations = 20});
  EXPECT_GT(position_rmse(sample.graph, sample.truth), 1.0);  // metres, in a room of 4 m
}

INSTANTIATE_TEST_SUITE_P(Shares, FalseLoops, testing::Values(0.1, 0.2, 0.4), [](const auto& share) {
  return "Percent" + std::to_string(std::lround(100 * share.param));
});

TEST(Gnc, WithoutFalseLoopsOneSolveIsEnough) {
  SampleGraph sample = make_rounds(60, 1);
  const Summary summary = optimize(sample.graph, {.loss = RobustLoss::kGnc, .loss_scale = 6});
  EXPECT_TRUE(summary.converged);
  EXPECT_LE(summary.solves, 2);
  EXPECT_EQ(summary.rejected_edges(), 0);
}

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

SE3 metres_ahead(double x) { return {Matrix3::Identity(), {x, 0, 0}}; }

/// Two chains of three nodes a metre apart, 0 to 2 and 3 to 5, without an edge between them.
PoseGraph two_chains() {
  PoseGraph graph;
  for (int i = 0; i < 6; ++i) graph.add_node({i, metres_ahead(i)});
  const Matrix6 certain = 1e4 * Matrix6::Identity();
  for (const int i : {0, 1, 3, 4}) graph.add_edge({i, i + 1, metres_ahead(1), certain});
  return graph;
}

PoseGraphEdge loop(NodeId from, NodeId to, double x, double information) {
  return {from, to, metres_ahead(x), information * Matrix6::Identity(), EdgeKind::kLoop, true};
}

// Two edges that contradict each other were both rejected, and the second chain floated.
TEST(Gnc, APartOfTheGraphKeepsTheBestOfTheEdgesThatConnectIt) {
  PoseGraph graph = two_chains();
  graph.add_edge(loop(2, 3, 4, 1e4));
  graph.add_edge(loop(2, 3, 90, 1e4));
  const Summary summary = optimize(graph, {.loss = RobustLoss::kGnc});
  // Neither is better than the other.
  EXPECT_EQ(summary.weights[4] + summary.weights[5], 1);
  // From 0 to 5: twice 1 m, the edge that was kept, twice 1 m.
  const double length = summary.weights[4] == 1 ? 8 : 94;
  EXPECT_NEAR(graph.nodes()[5].T_world_node.translation().x(), length, 1e-6);
  EXPECT_THAT(summary.notes,
              ElementsAre(HasSubstr("1 edge kept that the loss rejected, the best of those without "
                                    "which a part of the graph would come loose (2 -> 3)"),
                          HasSubstr("all that closes a loop was rejected, 1 edge")));
}

TEST(Gnc, FixedPartsNeedNoConnection) {
  PoseGraph graph = two_chains();
  graph.set_fixed(0, true);
  graph.set_fixed(3, true);
  graph.add_edge(loop(2, 3, 50, 1e4));
  const Summary summary = optimize(graph, {.loss = RobustLoss::kGnc});
  EXPECT_THAT(summary.weights, ElementsAre(1, 1, 1, 1, 0));
}

TEST(Gnc, SaysWhenAllThatClosesALoopWasRejected) {
  PoseGraph graph = two_chains();
  graph.add_edge({2, 3, metres_ahead(1), 1e4 * Matrix6::Identity()});
  graph.add_edge(loop(0, 5, 1, 1e4));
  const Summary summary = optimize(graph, {.loss = RobustLoss::kGnc});
  EXPECT_EQ(summary.rejected_edges(), 1);
  EXPECT_THAT(summary.notes, ElementsAre(HasSubstr("all that closes a loop was rejected, 1 edge")));
  graph.add_edge(loop(0, 4, 4, 1e4));
  EXPECT_THAT(optimize(graph, {.loss = RobustLoss::kGnc}).notes, IsEmpty()) << "one is left";
  EXPECT_THAT(optimize(graph).notes, IsEmpty());
}

}  // namespace
}  // namespace cvo_slam
