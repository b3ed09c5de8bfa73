// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cvo_slam/render/scene.h"

namespace cvo_slam::render {

/// Whether a place is finite and near enough to be drawn.
[[nodiscard]] inline bool is_drawable(const Vector3& place) {
  return place.cwiseAbs().maxCoeff() <= kMaxCoordinate && place.allFinite();
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

/// The horizontal axes are along walls where most of the points' normals agree on them. Elsewhere
/// they are the world's own where its z or -y points up.
[[nodiscard]] LevelAxes level_axes(const Vector3& up, const std::vector<MapPoint>& points);

/// Where a scene is, in coordinates of its level axes. Points beyond it are few.
struct Extent {
  LevelAxes axes;
  Vector3 min = Vector3::Zero();
  Vector3 max = Vector3::Zero();
  bool empty = true;  ///< nothing can be drawn

  [[nodiscard]] Vector3 center() const { return axes.place((min + max) / 2); }
  /// Of its diagonal [m].
  [[nodiscard]] double size() const { return (max - min).norm(); }
};

/// At least half a metre along each axis, so that a single pose has a picture too.
[[nodiscard]] Extent extent_of(const Scene& scene);

/// Of the points within the extent every n-th, so that there are at most `enough`.
[[nodiscard]] std::vector<Vector3> points_within(const std::vector<MapPoint>& points,
                                                 const Extent& extent, std::size_t enough);

/// Places that stand for the whole scene when it is framed: those within the extent.
[[nodiscard]] std::vector<Vector3> framed_places(const Scene& scene, const Extent& extent);

}  // namespace cvo_slam::render
