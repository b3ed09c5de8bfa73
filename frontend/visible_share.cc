// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/frontend/visible_share.h"

#include <algorithm>

namespace cvo_slam {

double visible_share(const PointCloud& cloud, const SE3& T_camera_cloud,
                     const PinholeCamera& camera) {
  // The first points of a cloud are spread over its image as all are; a hundred give the share
  // within a few hundredths.
  constexpr std::size_t kPoints = 100;
  constexpr double kMinDepth = 0.1;  // [m]
  const std::size_t n = std::min(kPoints, cloud.size());
  if (n == 0) return 0;
  std::size_t visible = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vector3 point = T_camera_cloud * cloud.position(i);
    if (point.z() > kMinDepth && camera.contains(camera.project(point))) ++visible;
  }
  return static_cast<double>(visible) / static_cast<double>(n);
}

}  // namespace cvo_slam
