// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include <fmt/format.h>

#include "cvo_slam/frontend/tracking_doubt_internal.h"
#include "cvo_slam/frontend/tracking_judgement_internal.h"

namespace cvo_slam {
namespace {

/// Returns what is asked for after a loss of so many seconds.
LostOptions limits_after_loss(double seconds, LostOptions limits) {
  constexpr double kLong = 0.5;  // [s]
  const double factor = seconds > kLong ? 2 : 1.5;
  limits.min_overlap = std::min(1.0, factor * limits.min_overlap);
  limits.min_cos_theta = std::min(1.0, factor * limits.min_cos_theta);
  return limits;
}

/// Returns why the clouds do not match well enough; empty if they do.
std::string find_mismatch(const RegistrationResult& result, const LostOptions& limits) {
  if (result.status == RegistrationStatus::kFailed) return result.reason;
  if (result.overlap < limits.min_overlap) {
    return fmt::format("overlap {:.2f} is below {:.2f}", result.overlap, limits.min_overlap);
  }
  if (result.cos_theta < limits.min_cos_theta) {
    return fmt::format("cos_theta {:.2f} is below {:.2f}", result.cos_theta, limits.min_cos_theta);
  }
  return {};
}

/// Returns why the camera cannot have moved so far in this time; empty if it can.
std::string find_motion_fault(const SE3& motion, double seconds, const LostOptions& limits) {
  const double speed = motion.translation().norm() / seconds;
  const double angular_speed = motion.angle() / seconds;
  if (speed > limits.max_speed) {
    return fmt::format("speed {:.1f} m/s is above {:.1f}", speed, limits.max_speed);
  }
  if (angular_speed > limits.max_angular_speed) {
    return fmt::format("angular speed {:.1f} rad/s is above {:.1f}", angular_speed,
                       limits.max_angular_speed);
  }
  return {};
}

}  // namespace

std::string find_fault(const RegistrationResult& result, const TrackingSituation& situation,
                       const LostOptions& limits) {
  std::string mismatch = find_mismatch(
      result, situation.is_lost ? limits_after_loss(situation.seconds, limits) : limits);
  if (!mismatch.empty()) return mismatch;
  if (situation.doubt <= kDoubtful) return {};
  return find_motion_fault(situation.T_last_camera, situation.seconds, limits);
}

bool is_equal_rival(const Answer& answer, const RegistrationResult& result) {
  constexpr double kTranslation = 0.1;  // [m]
  constexpr double kRotation = 5;       // [deg]
  if (!answer.is_believed || answer.cos_theta < kAsGood * result.cos_theta) return false;
  const SE3 T_result_answer = result.T_fixed_moving.inverse() * answer.T_fixed_moving;
  const bool is_far = T_result_answer.translation().norm() > kTranslation ||
                      kDegrees * T_result_answer.angle() > kRotation;
  return is_far && are_apart(result.T_fixed_moving, result.covariance, answer.T_fixed_moving,
                             answer.covariance);
}

void KeyframePolicy::keyframe_made() {
  // The expectation falls with each keyframe unless it is met again: after some ten of them a fast
  // turn is over, and new holes in the depth are noticed.
  constexpr double kForgetting = 0.02;
  expected_overlap_ -= kForgetting;
}

std::string KeyframePolicy::reason(const RegistrationResult& result, double visible) {
  if (visible > 0) {
    expected_overlap_ = std::max(expected_overlap_, std::min(1.0, result.overlap / visible));
  }
  if (result.overlap < options_.min_overlap * expected_overlap_) return "overlap";
  if (result.T_fixed_moving.translation().norm() > options_.max_translation) return "translation";
  if (result.T_fixed_moving.angle() > options_.max_rotation) return "rotation";
  return {};
}

}  // namespace cvo_slam
