// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "cvo_slam/synthetic/scene.h"

namespace cvo_slam::synthetic {

/// Half line from `origin`; its points are origin + distance * direction. All in a shape's frame.
struct Ray {
  Vector3 origin;
  Vector3 direction;  ///< need not have unit length
};

/// Where a ray meets a shape.
struct Hit {
  double distance = 0;  ///< in lengths of the ray's direction
  int face = 0;         ///< part of the shape with one smooth surface
};

/// The surface of a shape at a point on one of its faces.
struct Surface {
  Vector3 normal;                 ///< unit, to the outside
  Vector3 right, down;            ///< unit directions of the texture's axes
  double u = 0, v = 0;            ///< position on the face [m]
  double size_u = 0, size_v = 0;  ///< extent of the face [m]
};

/// The nearest meeting at a positive distance.
[[nodiscard]] std::optional<Hit> intersect(const Box& box, const Ray& ray);
[[nodiscard]] std::optional<Hit> intersect(const Rectangle& rectangle, const Ray& ray);
[[nodiscard]] std::optional<Hit> intersect(const Cylinder& cylinder, const Ray& ray);
[[nodiscard]] std::optional<Hit> intersect(const Sphere& sphere, const Ray& ray);

[[nodiscard]] Surface surface_at(const Box& box, int face, const Vector3& point);
[[nodiscard]] Surface surface_at(const Rectangle& rectangle, int face, const Vector3& point);
[[nodiscard]] Surface surface_at(const Cylinder& cylinder, int face, const Vector3& point);
[[nodiscard]] Surface surface_at(const Sphere& sphere, int face, const Vector3& point);

/// Half extents of the axis-aligned bounding box around the origin [m].
[[nodiscard]] Vector3 half_extent(const Box& box);
[[nodiscard]] Vector3 half_extent(const Rectangle& rectangle);
[[nodiscard]] Vector3 half_extent(const Cylinder& cylinder);
[[nodiscard]] Vector3 half_extent(const Sphere& sphere);

/// Distance of a point in the shape's frame to its surface, 0 inside a solid [m].
[[nodiscard]] double distance(const Box& box, const Vector3& point);
[[nodiscard]] double distance(const Rectangle& rectangle, const Vector3& point);
[[nodiscard]] double distance(const Cylinder& cylinder, const Vector3& point);
[[nodiscard]] double distance(const Sphere& sphere, const Vector3& point);

}  // namespace cvo_slam::synthetic
