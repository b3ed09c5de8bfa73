// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <tuple>
#include <utility>

#include <Eigen/Geometry>

#include "cvo_slam/render/extent_internal.h"

namespace cvo_slam::render {
namespace {

/// Share of the points that is cut off at each end of an axis, so that stray points do not decide
/// the framing.
constexpr double kTrimmedShare = 0.004;
constexpr double kLeastSize = 0.5;  // [m]
/// Number of points that represent all of them.
constexpr std::size_t kEnoughPoints = 50'000;

/// Returns the turn that makes the horizontal axes parallel to walls at right angles [rad], at most
/// an eighth of a turn; 0 if the normals do not agree on a direction.
double direction_of_walls(const LevelAxes& axes, const std::vector<MapPoint>& points) {
  constexpr std::size_t kEnough = 100'000;
  constexpr double kLevel = 0.2;  // the normal of a wall is horizontal to 12 degrees
  const std::size_t step = 1 + points.size() / kEnough;
  std::complex<double> sum;
  double count = 0;
  for (std::size_t i = 0; i < points.size(); i += step) {
    const Vector3 normal = axes.coordinates(unit_normal(points[i]));
    const bool is_wall = std::fabs(normal.z()) < kLevel && normal.squaredNorm() > 0.25;
    if (!is_wall) continue;
    // The factor 4 makes the four wall directions of a room one.
    sum += std::polar(1.0, 4 * std::atan2(normal.y(), normal.x()));
    ++count;
  }
  constexpr double kLeastAgreement = 0.25;
  return std::abs(sum) > kLeastAgreement * count ? std::arg(sum) / 4 : 0;
}

std::vector<Vector3> sampled_points(const MapScene& scene) {
  const std::size_t step = 1 + scene.points.size() / kEnoughPoints;
  std::vector<Vector3> places;
  for (std::size_t i = 0; i < scene.points.size(); i += step) {
    const Vector3 place = scene.points[i].position.cast<double>();
    if (is_drawable(place)) places.push_back(place);
  }
  return places;
}

/// Returns the positions of all cameras. None is trimmed: a path is never cut off.
std::vector<Vector3> camera_places(const MapScene& scene) {
  std::vector<Vector3> places;
  const auto add = [&](const Vector3& place) {
    if (is_drawable(place)) places.push_back(place);
  };
  for (const Path& path : scene.paths) {
    for (const StampedPose& pose : path.poses) add(pose.T_world_camera.translation());
  }
  for (const SE3& keyframe : scene.keyframes) add(keyframe.translation());
  for (const Constraint& constraint : scene.constraints) {
    add(constraint.from);
    add(constraint.to);
  }
  return places;
}

/// Returns the range of a coordinate between its trimmed ends.
std::pair<double, double> trimmed_range(std::vector<double> values) {
  const auto last = static_cast<double>(values.size() - 1);
  const auto quantile = [&](double share) {
    const auto nth = values.begin() + static_cast<std::ptrdiff_t>(std::lround(share * last));
    std::nth_element(values.begin(), nth, values.end());
    return *nth;
  };
  return {quantile(kTrimmedShare), quantile(1 - kTrimmedShare)};
}

void include_points(Extent& extent, const std::vector<Vector3>& points) {
  if (points.empty()) return;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> values;
    values.reserve(points.size());
    for (const Vector3& point : points) values.push_back(extent.axes.coordinates(point)[axis]);
    std::tie(extent.min[axis], extent.max[axis]) = trimmed_range(std::move(values));
  }
  extent.empty = false;
}

void include_place(Extent& extent, const Vector3& place) {
  const Vector3 coordinates = extent.axes.coordinates(place);
  extent.min = extent.empty ? coordinates : Vector3(extent.min.cwiseMin(coordinates));
  extent.max = extent.empty ? coordinates : Vector3(extent.max.cwiseMax(coordinates));
  extent.empty = false;
}

}  // namespace

LevelAxes level_axes(const Vector3& up, const std::vector<MapPoint>& points) {
  const Vector3 u = up.normalized();
  // The one of x and z that is farther from up.
  const Vector3 hint = std::fabs(u.x()) < 0.9 ? Vector3::UnitX() : Vector3::UnitZ();
  const Vector3 right = (hint - hint.dot(u) * u).normalized();
  const LevelAxes axes{right, u.cross(right), u};
  const double turn = direction_of_walls(axes, points);
  const Vector3 turned = std::cos(turn) * axes.right + std::sin(turn) * axes.ahead;
  return {turned, u.cross(turned), u};
}

Extent extent_of(const MapScene& scene) {
  Extent extent;
  extent.axes = level_axes(scene.up, scene.points);
  include_points(extent, sampled_points(scene));
  for (const Vector3& place : camera_places(scene)) include_place(extent, place);
  const Vector3 missing = (Vector3::Constant(kLeastSize) - (extent.max - extent.min)).cwiseMax(0);
  extent.min -= missing / 2;
  extent.max += missing / 2;
  return extent;
}

std::vector<Vector3> points_within(const std::vector<MapPoint>& points, const Extent& extent,
                                   std::size_t enough) {
  const std::size_t step = 1 + points.size() / enough;
  std::vector<Vector3> places;
  for (std::size_t i = 0; i < points.size(); i += step) {
    const Vector3 place = points[i].position.cast<double>();
    const Vector3 c = extent.axes.coordinates(place);
    if ((c.array() >= extent.min.array()).all() && (c.array() <= extent.max.array()).all()) {
      places.push_back(place);
    }
  }
  return places;
}

std::vector<Vector3> framed_places(const MapScene& scene, const Extent& extent) {
  std::vector<Vector3> places = camera_places(scene);
  for (const Vector3& point : points_within(scene.points, extent, kEnoughPoints)) {
    places.push_back(point);
  }
  // A single place has no size of its own.
  constexpr std::size_t kFew = 3;
  if (places.size() < kFew) {
    places.push_back(extent.axes.place(extent.min));
    places.push_back(extent.axes.place(extent.max));
  }
  return places;
}

}  // namespace cvo_slam::render
