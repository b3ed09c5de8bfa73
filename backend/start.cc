// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/backend/chordal_initialization.h"
#include "cvo_slam/backend/robust_cost_internal.h"
#include "cvo_slam/backend/start_internal.h"

namespace cvo_slam {

bool choose_start(PoseGraph& graph, const OptimizerOptions& options) {
  if (options.initialization == Initialization::kGiven) return false;
  const auto chordal = chordal_initialization(graph);
  if (!chordal) return false;
  PoseGraph moved = graph;
  for (std::size_t i = 0; i < chordal->size(); ++i) moved.set_pose(i, (*chordal)[i]);
  if (options.initialization == Initialization::kAuto &&
      robust_cost(graph, options) <= robust_cost(moved, options)) {
    return false;
  }
  graph = std::move(moved);
  return true;
}

}  // namespace cvo_slam
