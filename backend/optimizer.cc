// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/backend/optimizer.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "cvo_slam/backend/connectivity_internal.h"
#include "cvo_slam/backend/gnc_internal.h"
#include "cvo_slam/backend/minimize_internal.h"
#include "cvo_slam/backend/robust_loss_internal.h"

namespace cvo_slam {
namespace {

SearchReport search(PoseGraph& graph, const OptimizerOptions& options) {
  if (options.loss == RobustLoss::kGnc) return graduate(graph, options);
  const bool started_chordal = choose_start(graph, options);
  const MinimizeReport report = minimize(graph, options);
  return {report.iterations,
          1,
          report.converged,
          report.reason,
          started_chordal,
          robust_weights(graph, options),
          {}};
}

}  // namespace

OptionSet describe(OptimizerOptions& o) {
  return OptionSet()
      .add("loss", o.loss,
           {{"none", RobustLoss::kNone},
            {"huber", RobustLoss::kHuber},
            {"cauchy", RobustLoss::kCauchy},
            {"gnc", RobustLoss::kGnc}},
           "Loss of the edges that may be outliers. gnc takes many solves and finds the outliers "
           "even among many; huber and cauchy only weaken them.")
      .add("loss_scale", o.loss_scale, {1e-3, 1e6}, "",
           "Error in standard deviations above which the loss takes effect. The default is the "
           "square root of chi-square's 99 % quantile with six degrees of freedom.")
      .add("window", o.window, {1, 1000000}, "edges",
           "Nodes farther than this many edges from the newest node are held, unless a full solve "
           "is asked for.")
      .expert()
      .add("max_iterations", o.max_iterations, {1, 100000}, "",
           "Most iterations of one solve. A graph that needs more than twenty is ill-conditioned.")
      .add("gnc_factor", o.gnc_factor, {1.05, 100}, "",
           "Factor by which gnc makes the loss less convex between two solves; 1.4 is the value of "
           "the paper.")
      .add("initialization", o.initialization,
           {{"auto", Initialization::kAuto},
            {"given", Initialization::kGiven},
            {"chordal", Initialization::kChordal}},
           "Poses at which the search starts: auto takes the given or the chordal poses, whichever "
           "cost less.")
      .add("solver", o.solver,
           {{"suitesparse", LinearSolver::kSuiteSparse}, {"eigen", LinearSolver::kEigen}},
           "Sparse Cholesky factorisation: suitesparse is faster on large graphs, eigen does not "
           "depend on a BLAS.")
      .add("cost_tolerance", o.cost_tolerance, {0, 1}, "",
           "A solve ends when an iteration lowers the cost by less than this share of it.");
}

std::size_t Summary::rejected_edges() const {
  return static_cast<std::size_t>(
      std::count_if(weights.begin(), weights.end(), [](double weight) { return weight < 0.5; }));
}

Summary optimize(PoseGraph& graph, const OptimizerOptions& options) {
  OptimizerOptions checked = options;
  describe(checked).check();
  const auto begin = std::chrono::steady_clock::now();
  const double initial_cost = robust_cost(graph, options);
  SearchReport report = search(graph, options);
  const double final_cost = robust_cost(graph, options);
  std::vector<std::string> notes = connectivity_notes(graph, report.weights, report.kept);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
  return {.initial_cost = initial_cost,
          .final_cost = final_cost,
          .iterations = report.iterations,
          .solves = report.solves,
          .converged = report.converged,
          .reason = std::move(report.reason),
          .started_chordal = report.started_chordal,
          .weights = std::move(report.weights),
          .seconds = elapsed.count(),
          .notes = std::move(notes)};
}

}  // namespace cvo_slam
