// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "cvo_slam/core/se3.h"
#include "cvo_slam/core/timestamp.h"

namespace cvo_slam {

/// Predicts the next pose of the camera under constant velocity.
class MotionModel {
 public:
  /// Forgets the velocity.
  void stop() { velocity_.reset(); }
  [[nodiscard]] bool is_moving() const { return velocity_.has_value(); }
  /// Takes a velocity that was found otherwise [right tangent a second].
  void assume(const Vector6& velocity) { velocity_ = velocity; }
  void update(const Timestamp& stamp, const SE3& T_world_camera);

  [[nodiscard]] SE3 predict(const Timestamp& stamp) const;
  /// The motion between two times: the camera's pose at `to` in its frame at `from`.
  [[nodiscard]] SE3 motion(const Timestamp& from, const Timestamp& to) const;
  /// Right tangent a second; zero where it is not known.
  [[nodiscard]] Vector6 velocity() const { return velocity_.value_or(Vector6::Zero()); }
  /// The velocity from the last pose to this one.
  [[nodiscard]] Vector6 velocity_to(const Timestamp& stamp, const SE3& T_world_camera) const;
  [[nodiscard]] const SE3& last_pose() const { return T_world_camera_; }
  [[nodiscard]] const Timestamp& last_stamp() const { return stamp_; }

 private:
  Timestamp stamp_;
  SE3 T_world_camera_;
  bool started_ = false;
  std::optional<Vector6> velocity_;  // right tangent a second
};

}  // namespace cvo_slam
