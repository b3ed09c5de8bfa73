// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/synthetic/path_planning_internal.h"
#include "cvo_slam/synthetic/world.h"

namespace cvo_slam::synthetic {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kDuration = 10;     // [s]
constexpr double kMargin = 0.3;      // distance of the camera from surfaces [m]
constexpr double kLargestPan = 0.9;  // pan of a hand-held camera to either side [rad]

/// Returns how far the camera may move from the anchor [m]: within the free space, and so that the
/// edge of the world stays out of view.
double reach(const World& world) {
  const Viewpoint& view = world.anchor.view;
  const double free = clearance(world.scene, view.position) - kMargin;
  const double sideways =
      (view.target - view.position).norm() * std::tan(std::min(world.anchor.pan, kLargestPan));
  const double result = std::min({0.4, free, sideways});
  if (result > 0.02) return result;
  throw OptionError(fmt::format(
      "camera path: the anchor leaves no space to move; put it farther than {} m from all surfaces",
      kMargin + 0.02));
}

/// Returns the directions right, up and forward of the camera at the anchor.
Matrix3 axes_at(const Viewpoint& view) {
  const Matrix3 R = look_at(view.position, view.target).rotation();
  Matrix3 axes;
  axes << R.col(0), -R.col(1), R.col(2);
  return axes;
}

/// Returns the target turned about the vertical axis through the viewpoint.
Vector3 turned_target(const Viewpoint& view, double yaw) {
  return view.position + so3_exp({0, 0, yaw}) * (view.target - view.position);
}

PathPlan closed_plan(int count, double duration, const Tremor& tremor,
                     const std::function<Viewpoint(double angle)>& at) {
  PathPlan plan;
  plan.duration = duration;
  plan.tremor = tremor;
  for (int i = 0; i < count; ++i) plan.viewpoints.push_back(at(kTurn * i / count));
  return plan;
}

PathPlan handheld(const World& world, const Tremor& tremor) {
  const Viewpoint& view = world.anchor.view;
  const double size = reach(world);
  const double pan = std::min(0.5 * world.anchor.pan, kLargestPan);
  const Matrix3 axes = axes_at(view);
  return closed_plan(24, kDuration, tremor, [&](double angle) -> Viewpoint {
    const Vector3 offset(std::sin(angle), 0.5 * std::sin(2 * angle + 0.6),
                         0.6 * std::sin(3 * angle + 1.9));
    const Vector3 shift = size / 1.3 * (axes * offset);  // |offset| < 1.3
    return {view.position + shift,
            turned_target(view, pan * std::sin(2 * angle + 1)) + 0.3 * shift};
  });
}

PathPlan orbit(const World& world, const Tremor& tremor) {
  const Viewpoint& view = world.anchor.view;
  const Vector3 from_target = view.position - view.target;
  const double arc = std::min(0.7 * reach(world) / from_target.head<2>().norm(), 1.0);
  return closed_plan(16, kDuration, tremor, [&](double angle) -> Viewpoint {
    const Vector3 position = view.target + so3_exp({0, 0, arc * std::sin(angle)}) * from_target;
    return {position + Vector3(0, 0, 0.3 * arc * std::cos(angle)), view.target};
  });
}

PathPlan walk(const World& world, const Tremor& tremor) {
  if (world.anchor.pan < std::numbers::pi) {
    throw OptionError(
        "camera path: a walk needs a world that can be seen all around; use "
        "handheld, orbit, rotate, still or shake");
  }
  constexpr double kSpacing = 0.4;  // [m]
  constexpr double kPace = 0.7;     // [m/s]
  PathPlan own = world.path.plan();
  own.tremor.translation = 0;
  const CameraPath smooth(own);
  std::vector<Vector3> corners;
  const auto samples = static_cast<int>(8 * own.viewpoints.size());
  for (int i = 0; i < samples; ++i) {
    const double share = static_cast<double>(i) / (own.closed ? samples : samples - 1);
    corners.push_back(smooth.T_world_camera(share * smooth.duration()).translation());
  }
  PathPlan plan;
  plan.viewpoints = walk_along(corners, own.closed, kSpacing, 1.5, 0.15);
  plan.closed = own.closed;
  plan.duration = kSpacing / kPace * static_cast<double>(plan.viewpoints.size());
  plan.tremor = tremor;
  return plan;
}

/// Returns a plan that turns on the spot, all around if the world allows it.
PathPlan rotate(const World& world, Tremor tremor) {
  const Viewpoint& view = world.anchor.view;
  tremor.translation = 0;
  const bool all_around = world.anchor.pan >= std::numbers::pi;
  // The control points of a full turn are on a polygon; many of them keep the speed even.
  return closed_plan(36, all_around ? 12 : kDuration, tremor, [&](double angle) -> Viewpoint {
    const double yaw = all_around ? angle : world.anchor.pan * std::sin(angle);
    return {view.position, turned_target(view, yaw)};
  });
}

PathPlan standing(const World& world, const Tremor& tremor) {
  return closed_plan(4, kDuration, tremor, [&](double) { return world.anchor.view; });
}

PathPlan plan_of(PathStyle style, const World& world, const Tremor& hand) {
  switch (style) {
    case PathStyle::kHandheld:
      return handheld(world, hand);
    case PathStyle::kOrbit:
      return orbit(world, hand);
    case PathStyle::kWalk:
      return walk(world, hand);
    case PathStyle::kRotate:
      return rotate(world, hand);
    case PathStyle::kStill:
      return standing(world, {.translation = 0, .rotation = 0, .seed = hand.seed});
    case PathStyle::kShake:
      break;
  }
  return standing(world, {5 * hand.translation, 10 * hand.rotation, hand.seed});
}

/// Returns points at equal distances along the line through the corners.
std::vector<Vector3> even_points(std::vector<Vector3> corners, bool closed, double spacing) {
  if (closed) corners.push_back(corners.front());
  double length = 0;
  for (std::size_t i = 1; i < corners.size(); ++i) length += (corners[i] - corners[i - 1]).norm();
  const int count = std::max(4, static_cast<int>(std::lround(length / spacing)));
  const double step = length / (closed ? count : count - 1);
  std::vector<Vector3> points;
  double passed = 0;  // length of the line up to the corner i - 1
  std::size_t i = 1;
  for (int k = 0; k < count; ++k) {
    double side = (corners[i] - corners[i - 1]).norm();
    while (k * step - passed > side && i + 1 < corners.size()) {
      passed += side;
      ++i;
      side = (corners[i] - corners[i - 1]).norm();
    }
    const double share = side > 0 ? std::min(1.0, (k * step - passed) / side) : 0;
    points.emplace_back(corners[i - 1] + share * (corners[i] - corners[i - 1]));
  }
  return points;
}

}  // namespace

std::vector<Viewpoint> walk_along(const std::vector<Vector3>& corners, bool closed, double spacing,
                                  double ahead, double drop) {
  const std::vector<Vector3> points = even_points(corners, closed, spacing);
  const std::size_t count = points.size();
  const auto steps = std::max<std::size_t>(1, static_cast<std::size_t>(ahead / spacing));
  std::vector<Viewpoint> viewpoints;
  for (std::size_t i = 0; i < count; ++i) {
    Vector3 target;
    if (closed || i + steps < count) {
      target = points[(i + steps) % count];
    } else {
      const Vector3 direction = (points[count - 1] - points[count - 2]).normalized();
      target = points[count - 1] + static_cast<double>(i + steps + 1 - count) * spacing * direction;
    }
    viewpoints.push_back({points[i], target - Vector3(0, 0, drop)});
  }
  return viewpoints;
}

CameraPath path_of(PathStyle style, const World& world, std::uint32_t seed) {
  return CameraPath(plan_of(style, world, Tremor{.seed = seed}));
}

const std::vector<std::pair<std::string, PathStyle>>& path_style_names() {
  static const std::vector<std::pair<std::string, PathStyle>> names = {
      {"handheld", PathStyle::kHandheld}, {"orbit", PathStyle::kOrbit},
      {"walk", PathStyle::kWalk},         {"rotate", PathStyle::kRotate},
      {"still", PathStyle::kStill},       {"shake", PathStyle::kShake}};
  return names;
}

std::optional<Collision> first_collision(const WorldScene& scene, const CameraPath& path) {
  // A surface `free` away cannot be reached before the camera has moved as far. The distance is
  // measured again only then, which is rare, and thin sheets are not missed.
  constexpr double kStep = 0.01;  // [s]
  const auto steps = static_cast<long>(path.duration() / kStep) + 1;
  double free = 0;
  Vector3 measured_at = Vector3::Zero();
  for (long i = 0; i < steps; ++i) {
    const double seconds = static_cast<double>(i) * kStep;
    const Vector3 position = path.T_world_camera(seconds).translation();
    if ((position - measured_at).norm() + kNearestSurface < free) continue;
    const Nearest found = nearest(scene, position);
    if (found.distance < kNearestSurface) return Collision{seconds, found.primitive};
    free = found.distance;
    measured_at = position;
  }
  return std::nullopt;
}

void check_path(const WorldScene& scene, const CameraPath& path) {
  const auto collision = first_collision(scene, path);
  if (!collision) return;
  throw OptionError(fmt::format(
      "camera path: after {:.2f} s the camera is inside or nearer than {} m to primitive "
      "{} of the scene; use another path or speed",
      collision->seconds, kNearestSurface, collision->primitive));
}

}  // namespace cvo_slam::synthetic
