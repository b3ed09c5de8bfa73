// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <utility>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/pose_graph.h"
#include "cvo_slam/slam/keyframes_internal.h"
#include "cvo_slam/slam/map_graph_internal.h"

namespace cvo_slam {

namespace {

/// The order in which edges can be relied on.
int rank(EdgeKind kind) {
  switch (kind) {
    case EdgeKind::kOdometry:
      return 0;
    case EdgeKind::kProximity:
      return 1;
    case EdgeKind::kLoop:
      break;
  }
  return 2;
}

}  // namespace

Matrix6 transformed(const Matrix6& covariance, const SE3& T) {
  const Matrix6 adjoint = T.adjoint();
  return adjoint * covariance * adjoint.transpose();
}

EdgeCovariances both_ways(const SE3& T_from_to, const Matrix6& covariance) {
  return {covariance, transformed(covariance, T_from_to)};
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
  notes_.push_back({both_ways(T_older_newer, covariance), row});
}

void MapGraph::restore_edge(const PoseGraphEdge& edge) {
  optimizer_.add_edge(edge);
  notes_.push_back(
      {both_ways(edge.T_from_to, inverse_of_spd(measurement_information(edge))), std::nullopt});
}

std::optional<std::size_t> MapGraph::remove_edge(std::size_t index) {
  optimizer_.remove_edge(index);
  const std::optional<std::size_t> row = notes_[index].row;
  notes_.erase(notes_.begin() + static_cast<std::ptrdiff_t>(index));
  return row;
}

void MapGraph::replace_keyframe(std::size_t position, std::size_t edge) {
  const InheritedEdge link = seen_from(position, edge);
  const std::size_t substitute = link.other;
  std::vector<InheritedEdge> inherited;
  for (const std::size_t i : graph().edges_of(position)) {
    const InheritedEdge other = seen_from(position, i);
    if (other.other != substitute && !is_known(substitute, other)) inherited.push_back(other);
  }
  const auto number_of = [this](std::size_t i) {
    return static_cast<std::size_t>(graph().nodes()[i].id);
  };
  const SE3 T_substitute_node = link.T_node_other.inverse();
  const Matrix6 shared =
      static_cast<double>(inherited.size()) * both_ways(link.T_node_other, link.covariance).to_from;
  for (const InheritedEdge& other : inherited) {
    PairMeasurement measurement{
        T_substitute_node * other.T_node_other,
        transformed(shared, other.T_node_other.inverse()) + other.covariance};
    std::size_t older = substitute;
    std::size_t newer = other.other;
    if (older > newer) {
      std::swap(older, newer);
      measurement = {measurement.T_older_newer.inverse(),
                     transformed(measurement.covariance, measurement.T_older_newer)};
    }
    add_edge(other.kind, number_of(older), number_of(newer), measurement, other.row);
  }
  const std::vector<std::size_t> edges = graph().edges_of(position);
  std::for_each(edges.rbegin(), edges.rend(), [this](std::size_t i) {
    notes_.erase(notes_.begin() + static_cast<std::ptrdiff_t>(i));
  });
  optimizer_.remove_node(position);
}

/// An edge as one of its ends has it.
MapGraph::InheritedEdge MapGraph::seen_from(std::size_t position, std::size_t edge) const {
  const PoseGraphEdge& measured = graph().edges()[edge];
  const auto& [covariances, row] = notes_[edge];
  const auto [from, to] = graph().ends()[edge];
  if (position == from) return {measured.kind, to, measured.T_from_to, covariances.from_to, row};
  return {measured.kind, from, measured.T_from_to.inverse(), covariances.to_from, row};
}

/// True if an edge as good as this one leads from a keyframe to where it would lead. Nobody takes
/// back odometry; loops are taken back first.
bool MapGraph::is_known(std::size_t position, const InheritedEdge& edge) const {
  const std::vector<std::size_t>& edges = graph().edges_of(position);
  return std::any_of(edges.begin(), edges.end(), [&](std::size_t i) {
    const bool leads_there = graph().other_end(i, position) == edge.other;
    const bool is_believed = optimizer_.weights()[i] >= 0.5;
    return leads_there && is_believed && rank(graph().edges()[i].kind) <= rank(edge.kind);
  });
}

bool MapGraph::has_rows_below(std::size_t count) const {
  return std::all_of(notes_.begin(), notes_.end(), [count](const EdgeNotes& notes) {
    return notes.row.value_or(0) < std::max<std::size_t>(count, 1);
  });
}

void MapGraph::exchange(SavedState& state) {
  state(optimizer_, notes_);
  if (notes_.size() != graph().edges().size()) {
    throw DataError("a saved state has edges without covariances");
  }
}

}  // namespace cvo_slam
