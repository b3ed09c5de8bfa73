// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The geometry of the shapes. Rays and points are given in the frame of the shape.
#pragma once

#include <optional>

#include "cvo_slam/synthetic/world_scene.h"

namespace cvo_slam::synthetic {

/// The points origin + distance * direction, distance > 0.
struct Ray {
  Vector3 origin;
  Vector3 direction;  ///< need not have unit length
};

/// The point at which a ray meets a shape.
struct Hit {
  double distance = 0;  ///< in lengths of the ray's direction vector
  int face = 0;         ///< a face is a part of the shape with one smooth surface
};

/// The surface of a shape at a point on one of its faces.
struct Surface {
  Vector3 normal;                 ///< unit vector to the outside
  Vector3 right, down;            ///< unit vectors along the axes of the texture
  double u = 0, v = 0;            ///< position on the face [m]
  double size_u = 0, size_v = 0;  ///< extent of the face [m]
};

/// Returns the nearest hit at a positive distance; empty if the ray misses the shape.
[[nodiscard]] std::optional<Hit> intersect(const Box& box, const Ray& ray);
[[nodiscard]] std::optional<Hit> intersect(const Rectangle& rectangle, const Ray& ray);
[[nodiscard]] std::optional<Hit> intersect(const Cylinder& cylinder, const Ray& ray);
[[nodiscard]] std::optional<Hit> intersect(const Sphere& sphere, const Ray& ray);

/// Returns the surface at a point on a face.
[[nodiscard]] Surface surface_at(const Box& box, int face, const Vector3& point);
[[nodiscard]] Surface surface_at(const Rectangle& rectangle, int face, const Vector3& point);
[[nodiscard]] Surface surface_at(const Cylinder& cylinder, int face, const Vector3& point);
[[nodiscard]] Surface surface_at(const Sphere& sphere, int face, const Vector3& point);

/// Returns half the sides of the axis-aligned bounding box [m].
[[nodiscard]] Vector3 half_extent(const Box& box);
[[nodiscard]] Vector3 half_extent(const Rectangle& rectangle);
[[nodiscard]] Vector3 half_extent(const Cylinder& cylinder);
[[nodiscard]] Vector3 half_extent(const Sphere& sphere);

/// Returns the distance from a point to the surface [m]; 0 inside a solid.
[[nodiscard]] double distance(const Box& box, const Vector3& point);
[[nodiscard]] double distance(const Rectangle& rectangle, const Vector3& point);
[[nodiscard]] double distance(const Cylinder& cylinder, const Vector3& point);
[[nodiscard]] double distance(const Sphere& sphere, const Vector3& point);

}  // namespace cvo_slam::synthetic
