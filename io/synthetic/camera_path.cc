// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/io/synthetic/camera_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include "cvo_slam/core/error.h"
#include "cvo_slam/io/synthetic/random_internal.h"

namespace cvo_slam::synthetic {
namespace {

/// Weights of four successive control points at s in [0, 1] (uniform cubic B-spline).
std::array<double, 4> basis(double s) {
  const double r = 1 - s;
  return {r * r * r / 6, (3 * s * s * s - 6 * s * s + 4) / 6,
          (-3 * s * s * s + 3 * s * s + 3 * s + 1) / 6, s * s * s / 6};
}

}  // namespace

SE3 look_at(const Vector3& position, const Vector3& target) {
  const Vector3 forward = (target - position).normalized();
  const Vector3 right = forward.cross(Vector3::UnitZ()).normalized();
  Matrix3 R;
  R << right, forward.cross(right), forward;
  return {R, position};
}

CameraPath::CameraPath(std::vector<Viewpoint> viewpoints, double duration, const Tremor& tremor)
    : viewpoints_(std::move(viewpoints)), duration_(duration) {
  if (viewpoints_.size() < 4) {
    throw OptionError("camera path: a spline needs at least four viewpoints");
  }
  if (!(duration > 0)) throw OptionError("camera path: the duration must be positive");
  Random random(tremor.seed);
  constexpr std::array<std::pair<double, double>, 4> kBands = {
      {{0.5, 0.9}, {0.9, 1.6}, {1.6, 2.6}, {2.6, 4.0}}};  // [Hz]
  for (std::size_t axis = 0; axis < waves_.size(); ++axis) {
    const double size = axis < 3 ? tremor.translation : tremor.rotation;
    for (std::size_t k = 0; k < kBands.size(); ++k) {
      const double frequency = random.uniform(kBands[k].first, kBands[k].second);
      waves_[axis][k] = {std::max(1.0, std::round(frequency * duration)),
                         size / (frequency * frequency), random.uniform(0, 2 * std::numbers::pi)};
    }
  }
}

Viewpoint CameraPath::viewpoint(double seconds) const {
  const std::size_t count = viewpoints_.size();
  const double round = seconds / duration_;
  const double at = (round - std::floor(round)) * static_cast<double>(count);
  const auto first = std::min(static_cast<std::size_t>(at), count - 1);
  const auto weights = basis(at - static_cast<double>(first));
  Viewpoint result{Vector3::Zero(), Vector3::Zero()};
  for (std::size_t k = 0; k < weights.size(); ++k) {
    const Viewpoint& control = viewpoints_[(first + k) % count];
    result.position += weights[k] * control.position;
    result.target += weights[k] * control.target;
  }
  return result;
}

Vector6 CameraPath::tremor(double seconds) const {
  Vector6 sum = Vector6::Zero();
  for (std::size_t axis = 0; axis < waves_.size(); ++axis) {
    for (const Wave& wave : waves_[axis]) {
      const double angle = 2 * std::numbers::pi * wave.rounds * seconds / duration_ + wave.phase;
      sum[static_cast<Eigen::Index>(axis)] += wave.amplitude * std::sin(angle);
    }
  }
  return sum;
}

SE3 CameraPath::T_world_camera(double seconds) const {
  const Viewpoint view = viewpoint(seconds);
  return look_at(view.position, view.target) * SE3::exp(tremor(seconds));
}

}  // namespace cvo_slam::synthetic
