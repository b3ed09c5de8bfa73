// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "cvo_slam/core/trajectory.h"
#include "cvo_slam/core/trajectory_errors.h"
#include "cvo_slam/plot/figure.h"

namespace cvo_slam {

/// Returns top, front and side views of an estimate [m], drawn over the reference if there is one.
/// Both must be in the same world (align_positions()). The up direction is z, as in motion capture,
/// if the mean up direction of the reference's cameras is nearer to z than to -y. Otherwise, and
/// without a reference, it is -y, as in the frame of a camera, and z points ahead. Coordinates far
/// from zero are drawn relative to an origin near the first pose, which the labels of the axes
/// name.
[[nodiscard]] Figure trajectory_figure(const std::vector<StampedPose>& reference,
                                       const std::vector<StampedPose>& estimate);

/// One kind of error over time. Its name, such as "ATE" or "RPE 1 s", stands in the panel titles.
struct ErrorCurve {
  std::string name;               ///< in the titles
  std::vector<PoseError> errors;  ///< in ascending order of stamps
};

/// Returns the translation [mm] and rotation [deg] errors of each curve over the seconds since the
/// first error of all curves: two panels a curve, with the RMSE in their titles. Missing frames
/// interrupt the lines.
[[nodiscard]] Figure error_figure(const std::vector<ErrorCurve>& curves);

}  // namespace cvo_slam
