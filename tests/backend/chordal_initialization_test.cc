// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "cvo_slam/backend/optimizer.h"
#include "cvo_slam/bench/graph_samples.h"
#include "cvo_slam/core/pose_graph.h"

namespace cvo_slam {
namespace {

/// Measurements without noise between random poses; the poses of the nodes are arbitrary.
PoseGraph exact_graph(const std::vector<SE3>& truth) {
  std::mt19937 rng(4);
  PoseGraph graph;
  graph.add_node({0, truth[0]});
  for (std::size_t i = 1; i < truth.size(); ++i) graph.add_node({static_cast<NodeId>(i), SE3()});
  for (std::size_t i = 1; i < truth.size(); ++i) {
    for (int k = 0; k < 2; ++k) {
      const std::size_t j = rng() % i;
      graph.add_edge(
          {static_cast<NodeId>(i), static_cast<NodeId>(j), truth[i].inverse() * truth[j]});
    }
  }
  return graph;
}

std::vector<SE3> random_poses(std::size_t count) {
  std::mt19937 rng(3);
  std::vector<SE3> poses;
  for (std::size_t i = 0; i < count; ++i) poses.push_back(SE3::exp(random_tangent(rng, 5, 2)));
  return poses;
}

TEST(ChordalInitialization, IsExactWithoutNoise) {
  const std::vector<SE3> truth = random_poses(40);
  const auto poses = chordal_initialization(exact_graph(truth));
  ASSERT_TRUE(poses);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    EXPECT_LT(((*poses)[i].matrix() - truth[i].matrix()).norm(), 1e-10);
  }
}

TEST(ChordalInitialization, HoldsFixedNodesAndTheFirstOfEachOtherComponent) {
  const std::vector<SE3> truth = random_poses(10);
  PoseGraph graph = exact_graph(truth);
  graph.set_pose(6, truth[6]);
  graph.set_fixed(6, true);
  graph.set_pose(0, SE3());  // no longer held: the component has a fixed node
  graph.add_node({20, truth[1]});
  graph.add_node({21, SE3()});
  graph.add_edge({20, 21, truth[2]});
  const auto poses = chordal_initialization(graph);
  ASSERT_TRUE(poses);
  EXPECT_LT(((*poses)[0].matrix() - truth[0].matrix()).norm(), 1e-10);
  EXPECT_EQ((*poses)[6].matrix(), truth[6].matrix());
  EXPECT_EQ((*poses)[10].matrix(), truth[1].matrix());
  EXPECT_LT(((*poses)[11].matrix() - (truth[1] * truth[2]).matrix()).norm(), 1e-12);
}

TEST(ChordalInitialization, IsEmptyIfANodeIsNotDetermined) {
  PoseGraph graph;
  graph.add_node({0, SE3()});
  graph.add_node({1, SE3()});
  graph.add_edge({0, 1, SE3(), Matrix6::Zero()});
  EXPECT_FALSE(chordal_initialization(graph));
}

}  // namespace
}  // namespace cvo_slam
