// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/point_cloud.h"
#include "cvo_slam/core/se3.h"

namespace cvo_slam {

/// visible_share() of two keyframes, each in the other's image; the lower one.
[[nodiscard]] double mutual_overlap(const PointCloud& a, const PointCloud& b, const SE3& T_a_b,
                                    const PinholeCamera& camera);

}  // namespace cvo_slam
