// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "cvo_slam/core/pose_graph.h"

namespace cvo_slam {

/// Covariances of right perturbations of T_source_node, for each node by its index, along the most
/// certain path of edges. More than the true ones, which all paths together make smaller, and
/// without a factorisation of the whole graph. Empty where no path leads.
[[nodiscard]] std::vector<std::optional<Matrix6>> path_covariances(const PoseGraph& graph,
                                                                   std::size_t source);

}  // namespace cvo_slam
