// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "cvo_slam/core/point_cloud.h"
#include "cvo_slam/core/se3.h"

namespace cvo_slam {

/// Where a camera with a rolling shutter would have seen the points at its stamp, when the row in
/// the middle of the image was read. The camera moves with `velocity` (right tangent a second); a
/// row's pixels were seen (row - middle) / rows * readout_time after the stamp. To first order in
/// the motion: p + dt (v + w x p). Only positions of `cloud` differ from `seen`; they may be one.
inline void undo_rolling_shutter(const PointCloud& seen, const Vector6& velocity,
                                 double readout_time, int rows, PointCloud& cloud) {
  const double time_of_row = readout_time / rows;
  const double middle = 0.5 * (rows - 1);
  const Vector3 v = velocity.head<3>();
  const Vector3 w = velocity.tail<3>();
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const double dt = time_of_row * (static_cast<double>(seen.v[i]) - middle);
    const Vector3 p = seen.position(i);
    const Vector3 q = p + dt * (v + w.cross(p));
    cloud.x[i] = static_cast<float>(q.x());
    cloud.y[i] = static_cast<float>(q.y());
    cloud.z[i] = static_cast<float>(q.z());
  }
}

}  // namespace cvo_slam
