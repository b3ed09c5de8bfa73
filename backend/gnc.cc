// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <utility>

#include "cvo_slam/backend/connectivity_internal.h"
#include "cvo_slam/backend/gnc_internal.h"
#include "cvo_slam/backend/minimize_internal.h"
#include "cvo_slam/backend/robust_loss_internal.h"
#include "cvo_slam/core/pose_graph.h"

namespace cvo_slam {
namespace {

/// Limit of the steps of mu. A factor of 1.05 and an error of 10^13 c^2 need fewer.
constexpr int kMostSteps = 1000;

/// Limits of a rough solve: while weights still change it need not be exact.
constexpr int kStepIterations = 6;
constexpr double kStepTolerance = 1e-3;

/// Limit of the solves at the end, while edges are still accepted or rejected anew.
constexpr int kMostRefinements = 10;

OptimizerOptions plain_least_squares(OptimizerOptions options) {
  options.loss = RobustLoss::kNone;
  return options;
}

/// Returns the graph with each edge's information times its weight; edges of weight 0 are left out.
/// All nodes keep their indices.
PoseGraph weighted_graph(const PoseGraph& graph, const std::vector<double>& weights) {
  PoseGraph result;
  for (const PoseGraphNode& node : graph.nodes()) result.add_node(node);
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i] <= 0) continue;
    PoseGraphEdge edge = graph.edges()[i];
    edge.information *= weights[i];
    result.add_edge(edge);
  }
  return result;
}

void take_poses(PoseGraph& graph, const PoseGraph& from) {
  for (std::size_t i = 0; i < from.nodes().size(); ++i) {
    graph.set_pose(i, from.nodes()[i].T_world_node);
  }
}

/// Makes a few iterations on the weighted edges. They start again at the chordal poses if those
/// cost less, because the relaxation has no local minima. The chordal poses alone are not exact
/// enough to judge edges where odometry is certain.
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

/// Solves the weighted graph; moves the poses.
SearchReport solve_weighted(PoseGraph& graph, const OptimizerOptions& options,
                            std::vector<double> weights) {
  PoseGraph part = weighted_graph(graph, weights);
  const OptimizerOptions plain = plain_least_squares(options);
  const bool started_chordal = choose_start(part, plain);
  const MinimizeReport report = minimize(part, plain);
  take_poses(graph, part);
  return {report.iterations,  1, report.converged, report.reason, started_chordal,
          std::move(weights), {}};
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

/// Weights of the edges, and the edges that reconnect_parts() kept.
struct Decision {
  std::vector<double> weights;
  std::vector<std::size_t> kept;
};

/// Keeps the parts of the graph connected. Without a connection, errors of the edges between two
/// parts would not say which of them is right.
void reconnect(const PoseGraph& graph, Decision& decision) {
  const std::vector<std::size_t> kept = reconnect_parts(graph, decision.weights);
  decision.kept.insert(decision.kept.end(), kept.begin(), kept.end());
}

/// Returns the weights, each 0 or 1 except for edges that are undecided when the steps run out;
/// moves the poses.
Decision graduated_decision(PoseGraph& graph, const OptimizerOptions& options) {
  const double c2 = options.loss_scale * options.loss_scale;
  Decision decision{std::vector<double>(graph.edges().size(), 1.0), {}};
  std::vector<double>& weights = decision.weights;
  fit_roughly(graph, options, weights);
  std::vector<double> errors = robust_squared_errors(graph);
  const double largest = errors.empty() ? 0 : *std::max_element(errors.begin(), errors.end());
  if (largest <= c2) return decision;
  double mu = c2 / std::max(2 * largest - c2, c2);  // Remark 5 of the paper: nearly convex
  for (int step = 0; step < kMostSteps; ++step) {
    std::transform(errors.begin(), errors.end(), weights.begin(),
                   [&](double s) { return gnc_weight(s, c2, mu); });
    reconnect(graph, decision);
    if (is_decided(weights)) break;
    fit_roughly(graph, options, weights);
    errors = robust_squared_errors(graph);
    mu *= options.gnc_factor;
  }
  return decision;
}

}  // namespace

double gnc_weight(double s, double c2, double mu) {
  if (s <= mu / (mu + 1) * c2) return 1;
  if (s >= (mu + 1) / mu * c2) return 0;
  return std::clamp(std::sqrt(c2 * mu * (mu + 1) / s) - mu, 0.0, 1.0);
}

SearchReport graduate(PoseGraph& graph, const OptimizerOptions& options) {
  PoseGraph trial = graph;
  Decision decision = graduated_decision(trial, options);
  if (options.initialization == Initialization::kGiven) take_poses(graph, trial);
  SearchReport total = solve_weighted(graph, options, decision.weights);
  // The rough poses may have put an edge near the limit on the wrong side.
  OptimizerOptions again = options;
  again.initialization = Initialization::kGiven;
  for (int i = 0; i < kMostRefinements; ++i) {
    decision.weights = robust_weights(graph, options);
    reconnect(graph, decision);
    if (decision.weights == total.weights) break;
    SearchReport last = solve_weighted(graph, again, decision.weights);
    last.iterations += total.iterations;
    last.solves += total.solves;
    last.started_chordal = total.started_chordal;
    total = std::move(last);
  }
  total.kept = std::move(decision.kept);
  return total;
}

}  // namespace cvo_slam
