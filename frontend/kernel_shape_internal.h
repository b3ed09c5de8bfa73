// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "cvo_slam/core/point_cloud.h"
#include "cvo_slam/frontend/registration.h"

namespace cvo_slam {

/// PointCloud::surface_noise at which a kernel is as thick across a surface as it is long [1/m]: a
/// little less than a Kinect's.
inline constexpr double kUselessSurfaceNoise = 1e-3;

/// Returns true if the kernels of a cloud's points are not all balls.
[[nodiscard]] bool is_shaped(const PointCloud& cloud, const KernelOptions& kernel);

/// Returns a = sqrt(alpha) d of a point in its own frame, d the direction of its ray, alpha =
/// sigma^2 / (ell^2 + sigma^2); zero without noise. (I - a a^T) / ell^2 is the precision of a
/// kernel that knows of the noise along the ray alone: no kernel reaches further.
[[nodiscard]] Vector3 kernel_ray(const PointCloud& cloud, std::size_t j,
                                 const KernelOptions& kernel, double length_scale);

/// Returns P, ell^2 times the precision of a point's kernel, in a frame that its own is rotated
/// into (docs/theory/cvo.md).
[[nodiscard]] Matrix3 kernel_precision(const PointCloud& cloud, std::size_t j,
                                       const Matrix3& rotation, const KernelOptions& kernel,
                                       double length_scale);

}  // namespace cvo_slam
