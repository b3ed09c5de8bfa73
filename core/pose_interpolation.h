// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "cvo_slam/core/trajectory.h"

namespace cvo_slam {

/// The pose at `stamp`, on the SE(3) geodesic between the two poses around it; `poses` in ascending
/// order of stamps. Empty outside their range, and where those two are more than `max_gap` [s]
/// apart. A stamp that occurs in `poses` gives that pose.
[[nodiscard]] std::optional<SE3> interpolate_at(const std::vector<StampedPose>& poses,
                                                const Timestamp& stamp, double max_gap);

}  // namespace cvo_slam
