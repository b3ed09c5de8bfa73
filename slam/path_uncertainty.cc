// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <queue>
#include <utility>

#include <Eigen/LU>

#include "cvo_slam/core/pose_graph.h"
#include "cvo_slam/slam/path_uncertainty_internal.h"

namespace cvo_slam {
namespace {

/// An edge as it is walked.
struct Step {
  std::size_t target;
  SE3 T_source_target;
  Matrix6 covariance;  // of a right perturbation of T_source_target
};

Matrix6 transformed(const Matrix6& covariance, const SE3& T) {
  const Matrix6 adjoint = T.adjoint();
  return adjoint * covariance * adjoint.transpose();
}

std::vector<std::vector<Step>> steps_of_nodes(const PoseGraph& graph) {
  std::vector<std::vector<Step>> steps(graph.nodes().size());
  for (std::size_t i = 0; i < graph.edges().size(); ++i) {
    const PoseGraphEdge& edge = graph.edges()[i];
    const auto [a, b] = graph.ends()[i];
    // The way back from the residual's frame is the way there with the inverse rotation.
    const AlignedMatrix6 information = edge_information(edge.T_from_to.inverse(), edge.information);
    const Matrix6 covariance = information.inverse();
    steps[a].push_back({b, edge.T_from_to, covariance});
    steps[b].push_back({a, edge.T_from_to.inverse(), transformed(covariance, edge.T_from_to)});
  }
  return steps;
}

}  // namespace

std::vector<std::optional<Matrix6>> path_covariances(const PoseGraph& graph, std::size_t source) {
  const auto steps = steps_of_nodes(graph);
  std::vector<std::optional<Matrix6>> covariances(graph.nodes().size());
  std::vector<bool> done(graph.nodes().size());
  using Place = std::pair<double, std::size_t>;  // variance [m^2 + rad^2], node
  std::priority_queue<Place, std::vector<Place>, std::greater<>> open;
  covariances[source] = Matrix6::Zero();
  open.emplace(0, source);
  while (!open.empty()) {
    const std::size_t node = open.top().second;
    open.pop();
    if (done[node]) continue;
    done[node] = true;
    for (const Step& step : steps[node]) {
      if (done[step.target]) continue;
      const Matrix6 covariance =
          transformed(*covariances[node], step.T_source_target.inverse()) + step.covariance;
      auto& best = covariances[step.target];
      if (best && best->trace() <= covariance.trace()) continue;
      best = covariance;
      open.emplace(covariance.trace(), step.target);
    }
  }
  return covariances;
}

}  // namespace cvo_slam
