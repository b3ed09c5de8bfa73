// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "cvo_slam/core/point_cloud.h"
#include "cvo_slam/slam/view_overlap_internal.h"

namespace cvo_slam {

double mutual_overlap(const PointCloud& a, const PointCloud& b, const SE3& T_a_b,
                      const PinholeCamera& camera) {
  const double b_in_a = visible_share(b, T_a_b, camera);
  if (b_in_a == 0) return 0;
  return std::min(b_in_a, visible_share(a, T_a_b.inverse(), camera));
}

}  // namespace cvo_slam
