// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "cvo_slam/slam/place_agreement_internal.h"

namespace cvo_slam {

PlaceAgreement::PlaceAgreement(int frames, double max_speed, double max_angular_speed)
    : frames_(frames), max_speed_(max_speed), max_angular_speed_(max_angular_speed) {}

bool PlaceAgreement::see(const PlaceGuess& guess) {
  std::erase_if(guesses_, [&](const PlaceGuess& earlier) { return !agree(earlier, guess); });
  guesses_.push_back(guess);
  return count() >= frames_;
}

bool PlaceAgreement::agree(const PlaceGuess& a, const PlaceGuess& b) const {
  if (a.part != b.part) return false;
  constexpr double kLongest = 0.5;       // [s]; after more the camera may be anywhere
  constexpr double kTranslation = 0.05;  // [m]; that either may be wrong by, and still be right
  constexpr double kRotation = 0.05;     // [rad]
  const double seconds = std::abs(seconds_between(a.stamp, b.stamp));
  const SE3 motion = a.T_world_camera.inverse() * b.T_world_camera;
  return seconds <= kLongest &&
         motion.translation().norm() <= kTranslation + max_speed_ * seconds &&
         motion.angle() <= kRotation + max_angular_speed_ * seconds;
}

}  // namespace cvo_slam
