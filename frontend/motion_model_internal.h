// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "cvo_slam/core/point_cloud.h"
#include "cvo_slam/core/saved_state.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/core/timestamp.h"

namespace cvo_slam {

/// Predicts the next pose of the camera under constant velocity. Velocities are right tangents a
/// second, [m/s; rad/s].
class MotionModel {
 public:
  /// Forgets the velocity.
  void forget_velocity() { velocity_.reset(); }
  /// Returns true if the velocity is known.
  [[nodiscard]] bool has_velocity() const { return velocity_.has_value(); }
  /// Replaces the velocity by one that was found otherwise.
  void set_velocity(const Vector6& velocity) { velocity_ = velocity; }
  /// Takes the pose of a tracked frame, and the velocity from the pose before.
  void update(const Timestamp& stamp, const SE3& T_world_camera);

  /// Returns T_world_camera at a time.
  [[nodiscard]] SE3 predict(const Timestamp& stamp) const;
  /// Returns true if the camera may be away from where it is predicted by more than fine kernels
  /// reach: a hand turns ever faster by 20 rad/s^2 at most, in this time by 0.025 rad, and points 2
  /// m away move by 0.05 m.
  [[nodiscard]] bool is_far(const Timestamp& stamp) const {
    constexpr double kLongestPrediction = 0.05;  // [s]
    return seconds_between(stamp_, stamp) > kLongestPrediction;
  }
  /// Returns the motion in a time [s]: the camera's pose after it in its frame before.
  [[nodiscard]] SE3 motion_during(double seconds) const;
  /// Returns the velocity; zero if it is not known.
  [[nodiscard]] Vector6 velocity() const { return velocity_.value_or(Vector6::Zero()); }
  /// Returns the velocity from the last pose to this one.
  [[nodiscard]] Vector6 velocity_to(const Timestamp& stamp, const SE3& T_world_camera) const;
  [[nodiscard]] const SE3& last_pose() const { return T_world_camera_; }
  [[nodiscard]] const Timestamp& last_stamp() const { return stamp_; }
  void exchange(SavedState& state) { state(stamp_, T_world_camera_, started_, velocity_); }

 private:
  Timestamp stamp_;
  SE3 T_world_camera_;
  bool started_ = false;
  std::optional<Vector6> velocity_;
};

/// Moves the points of a camera with a rolling shutter to where it would have seen them at its
/// stamp, when the row in the middle of the image was read. A row's pixels were seen
/// (row - middle) / rows * readout_time [s] after the stamp, while the camera moved with `velocity`
/// (right tangent a second). To first order in the motion: p + dt (v + w x p). The cloud's pixels
/// tell the rows.
void undo_rolling_shutter(const Vector6& velocity, double readout_time, int rows,
                          PointCloud& cloud);

}  // namespace cvo_slam
