// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <vector>

#include <gtest/gtest.h>

#include "cvo_slam/slam/graph_prior_internal.h"

namespace cvo_slam {
namespace {

/// A motion like a camera's between keyframes.
SE3 step(double turn) {
  Vector6 tangent;
  tangent << 0.2, -0.1, 0.05, 0.1, turn, -0.2;
  return SE3::exp(tangent);
}

Matrix6 covariance_of(double translation, double rotation) {
  Matrix6 covariance = Matrix6::Zero();
  covariance.diagonal().head<3>().setConstant(translation * translation);
  covariance.diagonal().tail<3>().setConstant(rotation * rotation);
  covariance(0, 4) = covariance(4, 0) = 0.1 * covariance(0, 0);
  return covariance;
}

constexpr double kRotation = 0.02;  // [rad]
double translation(int i) { return 0.01 + 0.001 * i; }

/// Keyframes 0, 1, ... with an edge from each to the next.
MapGraph chain(int keyframes) {
  MapGraph graph{OptimizerOptions()};
  SE3 pose;
  for (int i = 0; i < keyframes; ++i) {
    graph.add_keyframe(static_cast<std::size_t>(i), pose);
    pose = pose * step(0.1 * i);
  }
  for (int i = 0; i + 1 < keyframes; ++i) {
    graph.add_edge(EdgeKind::kOdometry, static_cast<std::size_t>(i),
                   static_cast<std::size_t>(i) + 1,
                   {step(0.1 * i), covariance_of(translation(i), kRotation)}, {});
  }
  return graph;
}

/// Covariance of T_0_end of a chain: each step's own, carried to the end by the steps after it.
Matrix6 covariance_of_chain(int end) {
  Matrix6 sum = Matrix6::Zero();
  for (int i = 0; i < end; ++i) {
    SE3 after;
    for (int k = i + 1; k < end; ++k) after = after * step(0.1 * k);
    const Matrix6 adjoint = after.inverse().adjoint();
    sum += adjoint * covariance_of(translation(i), kRotation) * adjoint.transpose();
  }
  return sum;
}

void expect_near(const Matrix6& a, const Matrix6& b) {
  EXPECT_LT((a - b).norm(), 1e-12 * b.norm()) << "rounding";
}

TEST(PathSearch, AddsTheStepsOfAChain) {
  const MapGraph graph = chain(5);
  PathSearch search(graph, 0);
  for (int i = 4; i > 0; --i) {
    expect_near(search.covariance_to(static_cast<std::size_t>(i)).value(), covariance_of_chain(i));
  }
  EXPECT_EQ(search.covariance_to(0)->norm(), 0);
}

TEST(PathSearch, GoesBackAsItCame) {
  const MapGraph graph = chain(4);
  const SE3 T_0_3 = graph.pose(0).inverse() * graph.pose(3);
  const Matrix6 adjoint = T_0_3.adjoint();
  expect_near(PathSearch(graph, 3).covariance_to(0).value(),
              adjoint * covariance_of_chain(3) * adjoint.transpose());
}

TEST(PathSearch, TakesTheMoreCertainPath) {
  MapGraph graph = chain(4);
  const SE3 direct = graph.pose(0).inverse() * graph.pose(3);
  const auto add_direct = [&](double deviation) {
    graph.add_edge(EdgeKind::kLoop, 0, 3, {direct, covariance_of(deviation, deviation)}, {});
  };
  const Matrix6 before = PathSearch(graph, 0).covariance_to(3).value();
  PathSearch earlier(graph, 0);
  add_direct(1);
  EXPECT_EQ(PathSearch(graph, 0).covariance_to(3).value(), before);
  add_direct(0.001);
  EXPECT_LT(PathSearch(graph, 0).covariance_to(3)->trace(), 0.1 * before.trace());
  EXPECT_EQ(earlier.covariance_to(3).value(), before) << "it does not see edges added after it";
}

TEST(PathSearch, FindsNothingInAnotherSubmapButAcrossAGap) {
  MapGraph graph = chain(2);
  graph.add_keyframe(7, SE3());
  EXPECT_FALSE(PathSearch(graph, 0).covariance_to(2).has_value());
  const std::vector<Gap> gaps = {{1, 2, SE3(), both_ways(SE3(), covariance_of(1, 1))}};
  const auto covariance = PathSearch(graph, 0, gaps).covariance_to(2);
  ASSERT_TRUE(covariance.has_value());
  EXPECT_GT(covariance->trace(), 3);
}

}  // namespace
}  // namespace cvo_slam
