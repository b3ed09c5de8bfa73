// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>

#include "cvo_slam/frontend/motion_model_internal.h"

namespace cvo_slam {

void MotionModel::update(const Timestamp& stamp, const SE3& T_world_camera) {
  if (started_ && stamp > stamp_) velocity_ = velocity_to(stamp, T_world_camera);
  stamp_ = stamp;
  T_world_camera_ = T_world_camera;
  started_ = true;
}

Vector6 MotionModel::velocity_to(const Timestamp& stamp, const SE3& T_world_camera) const {
  return (T_world_camera_.inverse() * T_world_camera).log() / seconds_between(stamp_, stamp);
}

SE3 MotionModel::motion_during(double seconds) const {
  return velocity_ ? SE3::exp(seconds * *velocity_) : SE3();
}

SE3 MotionModel::predict(const Timestamp& stamp) const {
  return T_world_camera_ * motion_during(seconds_between(stamp_, stamp));
}

void undo_rolling_shutter(const Vector6& velocity, double readout_time, int rows,
                          PointCloud& cloud) {
  const double time_of_row = readout_time / rows;
  const double middle = 0.5 * (rows - 1);
  const Vector3 v = velocity.head<3>();
  const Vector3 w = velocity.tail<3>();
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const double dt = time_of_row * (static_cast<double>(cloud.v[i]) - middle);
    const Vector3 p = cloud.position(i);
    const Vector3 q = p + dt * (v + w.cross(p));
    cloud.x[i] = static_cast<float>(q.x());
    cloud.y[i] = static_cast<float>(q.y());
    cloud.z[i] = static_cast<float>(q.z());
    if (cloud.surfaces.empty()) continue;
    const Vector3 n = cloud.surfaces[i].normal.cast<double>();
    cloud.surfaces[i].normal = (n + dt * w.cross(n)).cast<float>();
  }
}

}  // namespace cvo_slam
