// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

#include "cvo_slam/slam/graph_prior_internal.h"

namespace cvo_slam {
namespace {

/// Standard deviation of the orientation in its least certain direction [rad].
double largest_rotation(const Matrix6& covariance) {
  const Eigen::SelfAdjointEigenSolver<Matrix3> solver(covariance.bottomRightCorner<3, 3>(),
                                                      Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, solver.eigenvalues()[2]));
}

}  // namespace

PathSearch::PathSearch(const MapGraph& graph, std::size_t source, std::span<const Gap> gaps)
    : graph_(graph), gaps_(gaps), edge_count_(graph.graph().edges().size()) {
  reached_[source].variance = 0;
  open_.emplace(0, source);
}

std::optional<Matrix6> PathSearch::covariance_to(std::size_t target) {
  while (!reached_[target].settled && !open_.empty()) {
    const std::size_t position = open_.top().second;
    open_.pop();
    Reached& reached = reached_[position];
    if (reached.settled) continue;
    reached.settled = true;
    leave(position);
  }
  const Reached& reached = reached_[target];
  return reached.settled ? std::optional(reached.covariance) : std::nullopt;
}

/// Takes all steps from a keyframe whose covariance is settled.
void PathSearch::leave(std::size_t position) {
  const Matrix6 covariance = reached_[position].covariance;
  const PoseGraph& graph = graph_.graph();
  for (const std::size_t i : graph.edges_of(position)) {
    if (i >= edge_count_) break;  // edges_of() ascends: the rest was added later
    const SE3& T_from_to = graph.edges()[i].T_from_to;
    const auto [from, to] = graph.ends()[i];
    if (position == from) {
      step(covariance, to, T_from_to, graph_.covariances(i).from_to);
    } else {
      step(covariance, from, T_from_to.inverse(), graph_.covariances(i).to_from);
    }
  }
  for (const Gap& gap : gaps_) {
    if (position == gap.from) step(covariance, gap.to, gap.T_from_to, gap.covariances.from_to);
    if (position == gap.to) {
      step(covariance, gap.from, gap.T_from_to.inverse(), gap.covariances.to_from);
    }
  }
}

void PathSearch::step(const Matrix6& covariance, std::size_t target, const SE3& T_position_target,
                      const Matrix6& step_covariance) {
  Reached& reached = reached_[target];
  if (reached.settled) return;
  const Matrix6 sum = transformed(covariance, T_position_target.inverse()) + step_covariance;
  if (reached.variance <= sum.trace()) return;
  reached.covariance = sum;
  reached.variance = sum.trace();
  open_.emplace(reached.variance, target);
}

PairPrior graph_prior(const MapGraph& graph, std::size_t older_position,
                      std::size_t newest_position, const Matrix6& covariance) {
  const SE3 T_older_newer = graph.pose(older_position).inverse() * graph.pose(newest_position);
  // The given covariance is of the way from the newest to the older one: turned round here.
  return {T_older_newer, transformed(covariance, T_older_newer.inverse())};
}

Matrix6 untracked_covariance(double seconds, const RelocalizationOptions& options) {
  const double translation = options.lost_speed * seconds;
  const double rotation = options.lost_angular_speed * seconds;
  Matrix6 covariance = Matrix6::Zero();
  covariance.diagonal().head<3>().setConstant(translation * translation);
  covariance.diagonal().tail<3>().setConstant(rotation * rotation);
  return covariance;
}

std::optional<PairPrior> prior_across_gaps(const MapState& map, std::size_t older_position,
                                           const Timestamp& now,
                                           const RelocalizationOptions& options) {
  const std::size_t newest_position = map.keyframes.size() - 1;
  const auto covariance =
      PathSearch(map.graph, newest_position, map.gaps).covariance_to(older_position);
  if (!covariance) return std::nullopt;
  PairPrior prior = graph_prior(map.graph, older_position, newest_position, *covariance);
  const double seconds = std::max(0.0, seconds_between(map.keyframes.newest().stamp, now));
  prior.covariance += untracked_covariance(seconds, options);
  // With more, a view from the opposite side could not be told from this one.
  constexpr double kLargest = 0.6;  // [rad]
  if (largest_rotation(prior.covariance) > kLargest) return std::nullopt;
  return prior;
}

}  // namespace cvo_slam
