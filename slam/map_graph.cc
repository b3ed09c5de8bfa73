// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/LU>

#include "cvo_slam/core/pose_graph.h"
#include "cvo_slam/slam/keyframes_internal.h"
#include "cvo_slam/slam/map_graph_internal.h"

namespace cvo_slam {

EdgeCovariances covariances_of(const PoseGraphEdge& edge) {
  // The way back from the residual's frame is the way there with the inverse rotation.
  const AlignedMatrix6 information = edge_information(edge.T_from_to.inverse(), edge.information);
  const Matrix6 covariance = information.inverse();
  const Matrix6 adjoint = edge.T_from_to.adjoint();
  return {covariance, adjoint * covariance * adjoint.transpose()};
}

void MapGraph::add_keyframe(std::size_t number, const SE3& T_world_camera) {
  optimizer_.add_node({node_id(number), T_world_camera});
}

void MapGraph::add_edge(const PoseGraphEdge& edge, std::optional<std::size_t> row) {
  optimizer_.add_edge(edge);
  covariances_.push_back(covariances_of(edge));
  rows_.push_back(row);
}

std::optional<std::size_t> MapGraph::remove_edge(std::size_t index) {
  optimizer_.remove_edge(index);
  const auto offset = static_cast<std::ptrdiff_t>(index);
  const std::optional<std::size_t> row = rows_[index];
  covariances_.erase(covariances_.begin() + offset);
  rows_.erase(rows_.begin() + offset);
  return row;
}

}  // namespace cvo_slam
