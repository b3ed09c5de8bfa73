// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// pose_graph: a square of four poses whose last edge closes the loop.
#include "cvo_slam/core/pose_graph.h"

#include <cstdio>
#include <numbers>

#include "cvo_slam/backend/optimizer.h"

int main() {
  using cvo_slam::SE3;
  const double drift = 0.03;  // [rad] too much in every corner
  const SE3 side(cvo_slam::so3_exp({0, 0, std::numbers::pi / 2}), {1, 0, 0});
  const SE3 drifted(cvo_slam::so3_exp({0, 0, std::numbers::pi / 2 + drift}), {1, 0, 0});
  cvo_slam::PoseGraph graph;
  SE3 pose;
  for (int i = 0; i < 4; ++i) {
    graph.add_node({.id = i, .T_world_node = pose});
    pose = pose * drifted;
  }
  for (int i = 0; i < 3; ++i) graph.add_edge({.from = i, .to = i + 1, .T_from_to = drifted});
  graph.add_edge(
      {.from = 3, .to = 0, .T_from_to = side, .kind = cvo_slam::EdgeKind::kLoop, .robust = true});
  const cvo_slam::Summary summary = cvo_slam::optimize(graph);
  std::printf("cost %.5f -> %.5f\n", summary.initial_cost, summary.final_cost);
}
