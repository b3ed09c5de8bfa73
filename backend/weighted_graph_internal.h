// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "cvo_slam/core/pose_graph.h"

namespace cvo_slam {

/// The graph with each edge's information times its weight; edges of weight 0 are left out. All
/// nodes keep their places.
[[nodiscard]] PoseGraph weighted_graph(const PoseGraph& graph, const std::vector<double>& weights);

}  // namespace cvo_slam
