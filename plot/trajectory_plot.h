// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "cvo_slam/core/trajectory.h"
#include "cvo_slam/core/trajectory_errors.h"
#include "cvo_slam/plot/figure.h"

namespace cvo_slam {

/// Top, front and side views of an estimate, in metres, over the reference where there is one. Both
/// must be in the same world (core/alignment.h). Up is z, as in motion capture,
/// where the reference's cameras are held so on the mean; else, and without a reference, it is -y,
/// as of a world that is a camera's frame, and z is ahead.
[[nodiscard]] Figure trajectory_figure(const std::vector<StampedPose>& reference,
                                       const std::vector<StampedPose>& estimate);

/// One kind of error over time, named for its panels: "ATE", "RPE 1 s".
struct ErrorCurve {
  std::string name;
  std::vector<PoseError> errors;
};

/// Translation [mm] and rotation [deg] of each curve over the seconds since the first error of all,
/// two panels a curve, with the RMSE in their titles. Lines are broken where frames are missing.
[[nodiscard]] Figure error_figure(const std::vector<ErrorCurve>& curves);

}  // namespace cvo_slam
