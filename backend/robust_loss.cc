// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "cvo_slam/backend/robust_loss_internal.h"
#include "cvo_slam/core/pose_graph.h"

namespace cvo_slam {

double robust_loss(double s, const OptimizerOptions& options) {
  const double c = options.loss_scale;
  switch (options.loss) {
    case RobustLoss::kHuber:
      return s <= c * c ? s : 2 * c * std::sqrt(s) - c * c;
    case RobustLoss::kCauchy:
      return c * c * std::log1p(s / (c * c));
    case RobustLoss::kGnc:
      return std::min(s, c * c);
    case RobustLoss::kNone:
      break;
  }
  return s;
}

double robust_weight(double s, const OptimizerOptions& options) {
  const double c = options.loss_scale;
  switch (options.loss) {
    case RobustLoss::kHuber:
      return s <= c * c ? 1 : c / std::sqrt(s);
    case RobustLoss::kCauchy:
      return 1 / (1 + s / (c * c));
    case RobustLoss::kGnc:
      return s <= c * c ? 1 : 0;
    case RobustLoss::kNone:
      break;
  }
  return 1;
}

double robust_cost(const PoseGraph& graph, const OptimizerOptions& options) {
  double sum = 0;
  for (std::size_t i = 0; i < graph.edges().size(); ++i) {
    const double s = squared_error(graph, i);
    sum += graph.edges()[i].robust ? robust_loss(s, options) : s;
  }
  return sum / 2;
}

std::vector<double> robust_weights(const PoseGraph& graph, const OptimizerOptions& options) {
  std::vector<double> weights(graph.edges().size(), 1.0);
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (graph.edges()[i].robust) weights[i] = robust_weight(squared_error(graph, i), options);
  }
  return weights;
}

}  // namespace cvo_slam
