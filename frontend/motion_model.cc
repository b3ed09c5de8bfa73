// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/frontend/motion_model_internal.h"

namespace cvo_slam {

void MotionModel::update(const Timestamp& stamp, const SE3& T_world_camera) {
  const double dt = seconds_between(stamp_, stamp);
  if (started_ && dt > 0) {
    velocity_ = (T_world_camera_.inverse() * T_world_camera).log() / dt;
  }
  stamp_ = stamp;
  T_world_camera_ = T_world_camera;
  started_ = true;
}

SE3 MotionModel::predict(const Timestamp& stamp) const {
  if (!velocity_) return T_world_camera_;
  return T_world_camera_ * SE3::exp(seconds_between(stamp_, stamp) * *velocity_);
}

}  // namespace cvo_slam
