// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "cvo_slam/core/association.h"
#include "cvo_slam/core/trajectory.h"

namespace cvo_slam {

inline Timestamp milliseconds(std::int64_t value) { return Timestamp(value * 1000000); }

/// A helix with turning orientation, a pose every 100 ms: not in a plane, not symmetric.
inline std::vector<StampedPose> helix(int count) {
  std::vector<StampedPose> poses;
  poses.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const double s = 0.1 * i;
    const Vector3 position(std::cos(s), 2 * std::sin(s), 0.3 * s);
    poses.push_back(
        {milliseconds(std::int64_t{100} * i), SE3(so3_exp({0.2 * s, 0.1, -0.3 * s}), position)});
  }
  return poses;
}

/// A camera that sways for some seconds, with a pose every 20 ms from a number of milliseconds on:
/// it turns ever differently, so that an offset of its clock shows.
inline std::vector<StampedPose> swaying(int seconds, std::int64_t first_ms = 0) {
  constexpr std::int64_t kPeriod = 20;
  std::vector<StampedPose> poses;
  for (std::int64_t ms = first_ms; ms < first_ms + std::int64_t{1000} * seconds; ms += kPeriod) {
    const double t = 1e-3 * static_cast<double>(ms);
    poses.push_back(
        {milliseconds(ms), SE3(so3_exp({0.5 * std::sin(2 * t), 0.3 * std::sin(3 * t), 0}),
                               {std::sin(t), std::cos(2 * t), 0.1 * t})});
  }
  return poses;
}

/// Returns the poses by a clock that is late by so many milliseconds.
inline std::vector<StampedPose> by_late_clock(std::vector<StampedPose> poses, std::int64_t ms) {
  for (StampedPose& pose : poses) {
    pose.stamp = Timestamp(pose.stamp.nanoseconds() + 1000000 * ms);
  }
  return poses;
}

/// Poses at x = 0, step, 2 step, ... without rotation, 100 ms apart.
inline std::vector<StampedPose> line(int count, double step = 1) {
  std::vector<StampedPose> poses;
  poses.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    poses.push_back(
        {milliseconds(std::int64_t{100} * i), SE3(Matrix3::Identity(), {step * i, 0, 0})});
  }
  return poses;
}

/// Matches every pose with the one of the same index.
inline std::vector<MatchedPose> match(const std::vector<StampedPose>& reference,
                                      const std::vector<StampedPose>& estimate) {
  std::vector<MatchedPose> matches;
  for (std::size_t i = 0; i < estimate.size(); ++i) {
    matches.push_back({estimate[i].stamp, reference[i].T_world_camera, estimate[i].T_world_camera});
  }
  return matches;
}

}  // namespace cvo_slam
