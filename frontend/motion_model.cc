// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
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

SE3 MotionModel::motion(const Timestamp& from, const Timestamp& to) const {
  return velocity_ ? SE3::exp(seconds_between(from, to) * *velocity_) : SE3();
}

SE3 MotionModel::predict(const Timestamp& stamp) const {
  return T_world_camera_ * motion(stamp_, stamp);
}

}  // namespace cvo_slam
