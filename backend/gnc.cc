// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "cvo_slam/backend/gnc_internal.h"
#include "cvo_slam/backend/minimize_internal.h"
#include "cvo_slam/backend/robust_cost_internal.h"
#include "cvo_slam/backend/start_internal.h"
#include "cvo_slam/backend/weighted_graph_internal.h"
#include "cvo_slam/core/pose_graph.h"

namespace cvo_slam {
namespace {

/// A factor of 1.05 and an error of 10^13 c^2 need fewer.
constexpr int kMostSteps = 1000;

/// While weights still change a solve need not be exact.
constexpr int kStepIterations = 6;
constexpr double kStepTolerance = 1e-3;

/// Of the last solve, while edges still change sides.
constexpr int kMostRefinements = 10;

OptimizerOptions plain_least_squares(OptimizerOptions options) {
  options.loss = RobustLoss::kNone;
  return options;
}

void take_poses(PoseGraph& graph, const PoseGraph& from) {
  for (std::size_t i = 0; i < from.nodes().size(); ++i) {
    graph.set_pose(i, from.nodes()[i].T_world_node);
  }
}

/// A few iterations on the weighted edges. They start anew at the chordal poses where those cost
/// less: the relaxation has no local minima to be caught in. It alone would do on some graphs, but
/// it is not exact enough to judge edges by where odometry is certain.
void fit_roughly(PoseGraph& graph, const OptimizerOptions& options,
                 const std::vector<double>& weights) {
  OptimizerOptions rough = plain_least_squares(options);
  rough.max_iterations = std::min(rough.max_iterations, kStepIterations);
  rough.cost_tolerance = std::max(rough.cost_tolerance, kStepTolerance);
  PoseGraph part = weighted_graph(graph, weights);
  choose_start(part, rough);
  minimize(part, rough);
  take_poses(graph, part);
}

void solve(PoseGraph& graph, const OptimizerOptions& options, Summary& summary) {
  PoseGraph part = weighted_graph(graph, summary.weights);
  const OptimizerOptions plain = plain_least_squares(options);
  summary.started_chordal = choose_start(part, plain) || summary.started_chordal;
  const MinimizeReport report = minimize(part, plain);
  take_poses(graph, part);
  ++summary.solves;
  summary.iterations += report.iterations;
  summary.converged = report.converged;
  summary.reason = report.reason;
}

std::vector<double> robust_squared_errors(const PoseGraph& graph) {
  std::vector<double> errors(graph.edges().size(), 0);
  for (std::size_t i = 0; i < errors.size(); ++i) {
    if (graph.edges()[i].robust) errors[i] = squared_error(graph, i);
  }
  return errors;
}

bool is_decided(const std::vector<double>& weights) {
  return std::all_of(weights.begin(), weights.end(), [](double w) { return w <= 0 || w >= 1; });
}

/// The weights, 0 or 1 each but for those on the border when the steps run out; moves the poses.
std::vector<double> graduated_weights(PoseGraph& graph, const OptimizerOptions& options) {
  const double c2 = options.loss_scale * options.loss_scale;
  std::vector<double> weights(graph.edges().size(), 1.0);
  fit_roughly(graph, options, weights);
  std::vector<double> errors = robust_squared_errors(graph);
  const double largest = errors.empty() ? 0 : *std::max_element(errors.begin(), errors.end());
  if (largest <= c2) return weights;
  double mu = c2 / std::max(2 * largest - c2, c2);  // Remark 5 of the paper: nearly convex
  for (int step = 0; step < kMostSteps; ++step) {
    std::transform(errors.begin(), errors.end(), weights.begin(),
                   [&](double s) { return gnc_weight(s, c2, mu); });
    if (is_decided(weights)) break;
    fit_roughly(graph, options, weights);
    errors = robust_squared_errors(graph);
    mu *= options.gnc_factor;
  }
  return weights;
}

}  // namespace

double gnc_weight(double s, double c2, double mu) {
  if (s <= mu / (mu + 1) * c2) return 1;
  if (s >= (mu + 1) / mu * c2) return 0;
  return std::clamp(std::sqrt(c2 * mu * (mu + 1) / s) - mu, 0.0, 1.0);
}

void graduate(PoseGraph& graph, const OptimizerOptions& options, Summary& summary) {
  PoseGraph trial = graph;
  summary.weights = graduated_weights(trial, options);
  if (options.initialization == Initialization::kGiven) take_poses(graph, trial);
  solve(graph, options, summary);
  // The rough poses may have put an edge near the border on the wrong side.
  OptimizerOptions again = options;
  again.initialization = Initialization::kGiven;
  for (int i = 0; i < kMostRefinements; ++i) {
    std::vector<double> weights = robust_weights(graph, options);
    if (weights == summary.weights) break;
    summary.weights = std::move(weights);
    solve(graph, again, summary);
  }
}

}  // namespace cvo_slam
