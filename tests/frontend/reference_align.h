// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cvo_slam/core/point_cloud.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/frontend/registration.h"

namespace cvo_slam {

/// The oracle: CVO written down as it reads in the paper (with its errata corrected,
/// docs/theory/cvo.md), over all pairs, in double precision. The fast code is tested against it.

/// F(T) = sum_ij c_ij k(x_i, T z_j), with k = 0 below the sparsification.
double reference_objective(const PointCloud& fixed, const PointCloud& moving,
                           const SE3& T_fixed_moving, const KernelOptions& kernel,
                           double length_scale);

/// Follows the gradient flow of F at one length scale until it stands still.
SE3 reference_align(const PointCloud& fixed, const PointCloud& moving,
                    const SE3& T_fixed_moving_init, const KernelOptions& kernel,
                    double length_scale);

}  // namespace cvo_slam
