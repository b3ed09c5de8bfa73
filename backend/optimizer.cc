// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/backend/optimizer.h"

#include <algorithm>
#include <chrono>

#include "cvo_slam/backend/gnc_internal.h"
#include "cvo_slam/backend/minimize_internal.h"
#include "cvo_slam/backend/robust_cost_internal.h"
#include "cvo_slam/backend/start_internal.h"

namespace cvo_slam {

std::size_t Summary::rejected_edges() const {
  return static_cast<std::size_t>(
      std::count_if(weights.begin(), weights.end(), [](double weight) { return weight < 0.5; }));
}

Summary optimize(PoseGraph& graph, const OptimizerOptions& options) {
  OptimizerOptions checked = options;
  describe(checked).check();
  const auto begin = std::chrono::steady_clock::now();
  Summary summary;
  summary.initial_cost = robust_cost(graph, options);
  if (options.loss == RobustLoss::kGnc) {
    graduate(graph, options, summary);
  } else {
    summary.started_chordal = choose_start(graph, options);
    const MinimizeReport report = minimize(graph, options);
    summary.solves = 1;
    summary.iterations = report.iterations;
    summary.converged = report.converged;
    summary.reason = report.reason;
    summary.weights = robust_weights(graph, options);
  }
  summary.final_cost = robust_cost(graph, options);
  summary.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return summary;
}

}  // namespace cvo_slam
