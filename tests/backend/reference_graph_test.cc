// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A generated graph with full information matrices and two false loops: the optima that an
// independent script found (tests/reference/make_graph.py).
#include <map>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "cvo_slam/backend/optimizer.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/core/pose_graph.h"
#include "cvo_slam/io/g2o.h"

namespace cvo_slam {
namespace {

std::filesystem::path reference_file(const char* name) {
  return std::filesystem::path(CVO_SLAM_SOURCE_DIR) / "tests" / "reference" / name;
}

struct Optimum {
  double cost = 0;
  std::map<NodeId, SE3> poses;  ///< of some nodes
};

/// By the name of the loss; "given" is the file as it stands.
std::map<std::string, Optimum> read_optima() {
  std::map<std::string, Optimum> optima;
  std::istringstream file(read_file(reference_file("graph_optima.txt")));
  for (std::string text; std::getline(file, text);) {
    std::istringstream words(text);
    std::string tag;
    std::string loss;
    words >> tag >> loss;
    if (tag == "cost") words >> optima[loss].cost;
    if (tag != "pose") continue;
    NodeId id = 0;
    Vector3 p;
    Eigen::Vector4d q;
    words >> id >> p.x() >> p.y() >> p.z() >> q.x() >> q.y() >> q.z() >> q.w();
    optima[loss].poses[id] = SE3::from_quaternion(q.x(), q.y(), q.z(), q.w(), p);
  }
  return optima;
}

/// The script's c.
constexpr double kLossScale = 4.1;

void expect_optimum(const std::string& name, const OptimizerOptions& options) {
  SCOPED_TRACE(name);
  const Optimum expected = read_optima().at(name);
  PoseGraph graph = read_g2o(reference_file("graph.g2o"));
  const Summary summary = optimize(graph, options);
  EXPECT_TRUE(summary.converged) << summary.reason;
  EXPECT_NEAR(summary.final_cost, expected.cost, 1e-9 * expected.cost);
  EXPECT_EQ(expected.poses.size(), 7U);
  for (const auto& [id, pose] : expected.poses) {
    const SE3 ours = graph.nodes()[graph.index_of(id)].T_world_node;
    // [m, rad]: the cost is flat to its 12th digit so far around the optimum.
    EXPECT_LT((pose.inverse() * ours).log().norm(), 1e-6) << "node " << id;
  }
}

TEST(ReferenceGraph, CostOfTheGivenPoses) {
  const double expected = read_optima().at("given").cost;
  EXPECT_NEAR(graph_cost(read_g2o(reference_file("graph.g2o"))), expected, 1e-9 * expected);
}

TEST(ReferenceGraph, OptimumOfEachLoss) {
  const std::map<std::string, RobustLoss> losses = {{"none", RobustLoss::kNone},
                                                    {"huber", RobustLoss::kHuber},
                                                    {"cauchy", RobustLoss::kCauchy},
                                                    {"truncated", RobustLoss::kGnc}};
  for (const auto& [name, loss] : losses) {
    expect_optimum(name, {.loss = loss, .loss_scale = kLossScale, .cost_tolerance = 1e-13});
  }
}

}  // namespace
}  // namespace cvo_slam
