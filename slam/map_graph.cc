// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/core/pose_graph.h"
#include "cvo_slam/slam/keyframes_internal.h"
#include "cvo_slam/slam/map_graph_internal.h"

namespace cvo_slam {

EdgeCovariances both_ways(const SE3& T_from_to, const Matrix6& covariance) {
  const Matrix6 adjoint = T_from_to.adjoint();
  return {covariance, adjoint * covariance * adjoint.transpose()};
}

void MapGraph::add_keyframe(std::size_t number, const SE3& T_world_camera) {
  optimizer_.add_node({node_id(number), T_world_camera});
}

void MapGraph::add_edge(EdgeKind kind, std::size_t older, std::size_t newer,
                        const PairMeasurement& measurement, std::optional<std::size_t> row) {
  const auto& [T_older_newer, covariance] = measurement;
  const bool may_be_wrong = kind != EdgeKind::kOdometry;
  optimizer_.add_edge({node_id(older), node_id(newer), T_older_newer,
                       edge_information(T_older_newer, inverse_of_spd(covariance)), kind,
                       may_be_wrong});
  covariances_.push_back(both_ways(T_older_newer, covariance));
  rows_.push_back(row);
}

void MapGraph::restore_edge(const PoseGraphEdge& edge) {
  optimizer_.add_edge(edge);
  covariances_.push_back(both_ways(edge.T_from_to, inverse_of_spd(measurement_information(edge))));
  rows_.emplace_back();
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
