// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "cvo_slam/core/trajectory.h"
#include "cvo_slam/core/trajectory_errors.h"
#include "cvo_slam/plot/figure.h"

namespace cvo_slam {

/// One of several estimates of the same path.
struct ComparedTrajectory {
  std::string name;
  std::vector<StampedPose> poses;  ///< in the reference's world
  std::vector<PoseError> errors;   ///< frame to frame
};

/// The estimates' cumulative distributions of translation and rotation error, each over the range
/// of errors that holds 95 % of every estimate's but hopeless ones', and the top view of each path
/// over the reference's. At most six estimates have colours of their own.
[[nodiscard]] Figure comparison_figure(const std::vector<StampedPose>& reference,
                                       const std::vector<ComparedTrajectory>& estimates);

}  // namespace cvo_slam
