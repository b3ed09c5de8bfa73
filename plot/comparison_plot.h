// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "cvo_slam/core/trajectory.h"
#include "cvo_slam/core/trajectory_errors.h"
#include "cvo_slam/plot/figure.h"

namespace cvo_slam {

/// One of several estimates of the same trajectory.
struct ComparedTrajectory {
  std::string name;                ///< in the legend and above its top view
  std::vector<StampedPose> poses;  ///< in the world of the reference
  std::vector<PoseError> errors;   ///< from frame to frame, by cvo_paper_options()
};

/// Returns a figure that compares estimates: the cumulative distributions of their translation and
/// rotation errors, and the top view of each trajectory over the reference. An error axis holds 95
/// % of the errors of each estimate, but at most four times those of the best one. Six estimates
/// have a style of their own; further ones repeat the styles.
[[nodiscard]] Figure comparison_figure(const std::vector<StampedPose>& reference,
                                       const std::vector<ComparedTrajectory>& estimates);

}  // namespace cvo_slam
