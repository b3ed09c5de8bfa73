// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cvo_slam/core/point_cloud.h"
#include "cvo_slam/core/se3.h"

namespace cvo_slam {

/// Returns the covariance of a right perturbation of the pose, tangent order [translation;
/// rotation], if each point p slides along its ray by an independent error, whose standard
/// deviation is `factor` times its ray_noise sigma. With J = [I, -[p]x] and the ray's direction d =
/// p / |p|, the least-squares pose has
///   C = M^-1 [sum sigma^2 d d^T, 0; 0, 0] M^-1,   M = sum J^T J.
/// The points must determine the pose. Points that are not finite are left out. Zero if the noise
/// is not known.
[[nodiscard]] Matrix6 depth_covariance(const PointCloud& cloud, double factor);

}  // namespace cvo_slam
