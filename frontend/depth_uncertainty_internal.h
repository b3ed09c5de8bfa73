// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cvo_slam/core/point_cloud.h"
#include "cvo_slam/core/se3.h"

namespace cvo_slam {

/// What errors of the depth do to a registration, where the standard deviation of a depth z is
/// sigma_z = depth_noise z^2.

/// The mean over the points of ell^2 / (ell^2 + sigma_z^2): how much less a point says than one
/// without depth noise, as pairs that it parts count less.
[[nodiscard]] double mean_precision(const PointCloud& cloud, double ell, double depth_noise);

/// The covariance of a right perturbation of the pose, tangent order [translation; rotation], when
/// each point slides along its ray, d = p / z, by an independent error of its depth. With
/// J = [I, -[p]x] and as d is parallel to p, least squares make of that
///   C = M^-1 [sum sigma_z^2 d d^T, 0; 0, 0] M^-1,   M = sum J^T J.
/// The points must determine the pose. Points that are not finite are left out.
[[nodiscard]] Matrix6 depth_covariance(const PointCloud& cloud, double depth_noise);

}  // namespace cvo_slam
