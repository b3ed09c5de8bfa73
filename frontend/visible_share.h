// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/point_cloud.h"
#include "cvo_slam/core/se3.h"

namespace cvo_slam {

/// The share of a cloud's points that lie in a camera's image, whatever is in between; of its first
/// hundred, which are spread over the image of a selected cloud as all are. 0 of no points.
[[nodiscard]] double visible_share(const PointCloud& cloud, const SE3& T_camera_cloud,
                                   const PinholeCamera& camera);

}  // namespace cvo_slam
