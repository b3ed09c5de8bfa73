// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cvo_slam/core/point_cloud.h"
#include "cvo_slam/core/se3.h"

namespace cvo_slam {

// The effect of depth errors on a registration. The standard deviation of a depth z is
// sigma_z = depth_noise z^2.

/// Returns the mean over the points of ell^2 / (ell^2 + sigma_z^2): the information of a point as a
/// share of that of a point without depth noise.
[[nodiscard]] double mean_precision(const PointCloud& cloud, double ell, double depth_noise);

/// Returns the covariance of a right perturbation of the pose, tangent order [translation;
/// rotation], if each point slides along its ray, d = p / z, by an independent error of its depth.
/// With J = [I, -[p]x], and because d is parallel to p, the least-squares pose has
///   C = M^-1 [sum sigma_z^2 d d^T, 0; 0, 0] M^-1,   M = sum J^T J.
/// The points must determine the pose. Points that are not finite are left out.
[[nodiscard]] Matrix6 depth_covariance(const PointCloud& cloud, double depth_noise);

}  // namespace cvo_slam
