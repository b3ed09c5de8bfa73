// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/synthetic/camera_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/synthetic/random_internal.h"

namespace cvo_slam::synthetic {
namespace {

/// Returns the weights of four successive control points at s in [0, 1] (uniform cubic B-spline).
std::array<double, 4> basis(double s) {
  const double r = 1 - s;
  return {r * r * r / 6, (3 * s * s * s - 6 * s * s + 4) / 6,
          (-3 * s * s * s + 3 * s * s + 3 * s + 1) / 6, s * s * s / 6};
}

/// Returns the control points: three more than segments.
std::vector<Viewpoint> spline_controls(const PathPlan& plan) {
  std::vector<Viewpoint> controls = plan.viewpoints;
  if (plan.closed) {
    controls.insert(controls.end(), plan.viewpoints.begin(), plan.viewpoints.begin() + 3);
  } else {  // the spline passes three equal control points at rest
    controls.insert(controls.begin(), 2, plan.viewpoints.front());
    controls.insert(controls.end(), 2, plan.viewpoints.back());
  }
  return controls;
}

void check(const PathPlan& plan) {
  if (plan.viewpoints.size() < 4) {
    throw OptionError(fmt::format("camera path: {} viewpoints are too few; give at least 4",
                                  plan.viewpoints.size()));
  }
  const auto positive = [](double value) { return std::isfinite(value) && value > 0; };
  if (!positive(plan.duration)) throw OptionError("camera path: the duration must be positive");
  if (!positive(plan.speed)) throw OptionError("camera path: the speed must be positive");
  if (plan.duration / plan.speed > kLongestPath) {
    throw OptionError(
        fmt::format("camera path: {} s at speed {} are more than a day; use a shorter "
                    "path or a higher speed",
                    plan.duration, plan.speed));
  }
  for (std::size_t i = 0; i < plan.viewpoints.size(); ++i) {
    const Vector3 view = plan.viewpoints[i].target - plan.viewpoints[i].position;
    if (view.head<2>().norm() > 0.01 * view.norm()) continue;
    throw OptionError(
        fmt::format("camera path: viewpoint {} must not look straight up or down; "
                    "move its target",
                    i + 1));
  }
}

}  // namespace

SE3 look_at(const Vector3& position, const Vector3& target) {
  const Vector3 forward = (target - position).normalized();
  const Vector3 right = forward.cross(Vector3::UnitZ()).normalized();
  Matrix3 R;
  R << right, forward.cross(right), forward;
  return {R, position};
}

CameraPath::CameraPath(PathPlan plan) : plan_(std::move(plan)) {
  check(plan_);
  controls_ = spline_controls(plan_);
  const Tremor& tremor = plan_.tremor;
  Random random(tremor.seed);
  constexpr std::array<std::pair<double, double>, 4> kBands = {
      {{0.5, 0.9}, {0.9, 1.6}, {1.6, 2.6}, {2.6, 4.0}}};  // [Hz]
  for (std::size_t axis = 0; axis < waves_.size(); ++axis) {
    const double size = axis < 3 ? tremor.translation : tremor.rotation;
    for (std::size_t k = 0; k < kBands.size(); ++k) {
      const double frequency = random.uniform(kBands[k].first, kBands[k].second);
      waves_[axis][k] = {std::max(1.0, std::round(frequency * plan_.duration)),
                         size / (frequency * frequency), random.uniform(0, 2 * std::numbers::pi)};
    }
  }
}

Viewpoint CameraPath::viewpoint(double share) const {
  const std::size_t segments = controls_.size() - 3;
  const double once = plan_.closed ? share - std::floor(share) : std::clamp(share, 0.0, 1.0);
  const double at = once * static_cast<double>(segments);
  const auto first = std::min(static_cast<std::size_t>(at), segments - 1);
  const auto weights = basis(at - static_cast<double>(first));
  Viewpoint result{Vector3::Zero(), Vector3::Zero()};
  for (std::size_t k = 0; k < weights.size(); ++k) {
    const Viewpoint& control = controls_[first + k];
    result.position += weights[k] * control.position;
    result.target += weights[k] * control.target;
  }
  return result;
}

Vector6 CameraPath::tremor(double share) const {
  Vector6 sum = Vector6::Zero();
  for (std::size_t axis = 0; axis < waves_.size(); ++axis) {
    for (const Wave& wave : waves_[axis]) {
      const double angle = 2 * std::numbers::pi * wave.rounds * share + wave.phase;
      sum[static_cast<Eigen::Index>(axis)] += wave.amplitude * std::sin(angle);
    }
  }
  return sum;
}

SE3 CameraPath::T_world_camera(double seconds) const {
  const double share = seconds * plan_.speed / plan_.duration;
  const Viewpoint view = viewpoint(share);
  return look_at(view.position, view.target) * SE3::exp(tremor(share));
}

}  // namespace cvo_slam::synthetic
