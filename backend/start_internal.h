// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cvo_slam/backend/optimizer_options.h"
#include "cvo_slam/core/pose_graph.h"

namespace cvo_slam {

/// Moves the poses to where the search is to start (OptimizerOptions::initialization); answers
/// whether those are the chordal ones.
bool choose_start(PoseGraph& graph, const OptimizerOptions& options);

}  // namespace cvo_slam
