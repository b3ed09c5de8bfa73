// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "cvo_slam/core/pose_graph.h"

namespace cvo_slam {

/// Poses near the optimum from the measurements alone: L. Carlone et al., "Initialization
/// Techniques for 3D SLAM", ICRA 2015, Sec. III-B. First the rotations as if any 3x3 matrix were
/// one, which is sparse linear least squares, each then rounded to the nearest rotation; then the
/// positions, given the rotations, another one. Of an edge's information only the mean weight of
/// its translation and of its rotation count. Held nodes (PoseGraph::held_nodes) stay where they
/// are; where the start of the others is does not matter. Empty where the weights of the edges are
/// too small to say where a node is.
[[nodiscard]] std::optional<std::vector<SE3>> chordal_initialization(const PoseGraph& graph);

}  // namespace cvo_slam
