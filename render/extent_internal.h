// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "cvo_slam/render/map_scene.h"

namespace cvo_slam::render {

/// Returns true if a position is finite and near enough to be drawn.
[[nodiscard]] inline bool is_drawable(const Vector3& place) {
  return place.cwiseAbs().maxCoeff() <= kMaxCoordinate && place.allFinite();
}

/// Returns the normal of a point, a unit vector; zero if the point has none. Foreign files have
/// normals of any length.
[[nodiscard]] inline Vector3 unit_normal(const MapPoint& point) {
  Vector3 normal = point.normal.cast<double>();
  const double length = normal.norm();
  constexpr double kRounding = 1e-3;  // of values in a file: the normal is used as it is
  if (std::abs(length - 1) < kRounding) return normal;
  constexpr double kLeast = 1e-3;
  return std::isfinite(length) && length > kLeast ? Vector3(normal / length) : Vector3::Zero();
}

/// The axes of a level world: two horizontal ones and up, right-handed.
struct LevelAxes {
  Vector3 right;
  Vector3 ahead;
  Vector3 up;

  [[nodiscard]] Vector3 coordinates(const Vector3& place) const {
    return {right.dot(place), ahead.dot(place), up.dot(place)};
  }
  [[nodiscard]] Vector3 place(const Vector3& coordinates) const {
    return coordinates.x() * right + coordinates.y() * ahead + coordinates.z() * up;
  }
};

/// Returns level axes. The horizontal ones are parallel to the walls if most of the points' normals
/// agree on a direction. Otherwise they are axes of the world, if its z or -y points up.
[[nodiscard]] LevelAxes level_axes(const Vector3& up, const std::vector<MapPoint>& points);

/// The box that a scene fills, in coordinates of its level axes. Few points lie outside.
struct Extent {
  LevelAxes axes;
  Vector3 min = Vector3::Zero();
  Vector3 max = Vector3::Zero();
  bool empty = true;  ///< true if nothing can be drawn

  /// Returns the length of the diagonal [m].
  [[nodiscard]] double size() const { return (max - min).norm(); }
};

/// Returns the extent of a scene: at least half a metre along each axis, so that a single pose can
/// be drawn too.
[[nodiscard]] Extent extent_of(const MapScene& scene);

/// Returns every n-th of the points inside the extent, so that there are at most `enough`.
[[nodiscard]] std::vector<Vector3> points_within(const std::vector<MapPoint>& points,
                                                 const Extent& extent, std::size_t enough);

/// Returns positions inside the extent that represent the scene when it is framed.
[[nodiscard]] std::vector<Vector3> framed_places(const MapScene& scene, const Extent& extent);

}  // namespace cvo_slam::render
