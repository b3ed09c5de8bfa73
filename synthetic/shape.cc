// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "cvo_slam/synthetic/shape_internal.h"

namespace cvo_slam::synthetic {
namespace {

// A box's face 2k is the one towards the positive k-th axis, 2k + 1 its opposite.
int face_of(int axis, bool positive) { return 2 * axis + (positive ? 0 : 1); }

/// Directions to the right and down of someone who looks at the face from outside.
std::array<Vector3, 2> face_axes(int face) {
  static const std::array<std::array<Vector3, 2>, 6> kAxes = {{
      {Vector3::UnitY(), -Vector3::UnitZ()},
      {-Vector3::UnitY(), -Vector3::UnitZ()},
      {-Vector3::UnitX(), -Vector3::UnitZ()},
      {Vector3::UnitX(), -Vector3::UnitZ()},
      {Vector3::UnitX(), -Vector3::UnitY()},
      {Vector3::UnitX(), Vector3::UnitY()},
  }};
  return kAxes[static_cast<std::size_t>(face)];
}

}  // namespace

std::optional<Hit> intersect(const Box& box, const Ray& ray) {
  // Slabs: the ray is inside the box where it is between all three pairs of faces. Written so that
  // a ray along a slab (inverse = inf) gives infinities, and without branches before the miss.
  const Eigen::Array3d inverse = ray.direction.array().inverse();
  const Eigen::Array3d low = (-0.5 * box.size - ray.origin).array() * inverse;
  const Eigen::Array3d high = (0.5 * box.size - ray.origin).array() * inverse;
  const Eigen::Array3d into = low.min(high);
  const Eigen::Array3d out = low.max(high);
  const double enter = std::max(std::max(into[0], into[1]), into[2]);
  const double leave = std::min(std::min(out[0], out[1]), out[2]);
  if (enter > leave || leave <= 0) return std::nullopt;

  const bool from_inside = enter <= 0;
  const double distance = from_inside ? leave : enter;
  const Eigen::Array3d& distances = from_inside ? out : into;
  const int axis = distances[0] == distance ? 0 : distances[1] == distance ? 1 : 2;
  return Hit{distance, face_of(axis, (ray.direction[axis] > 0) == from_inside)};
}

std::optional<Hit> intersect(const Rectangle& rectangle, const Ray& ray) {
  const double distance = -ray.origin.z() / ray.direction.z();
  if (!(distance > 0) || std::isinf(distance)) return std::nullopt;
  const double x = ray.origin.x() + distance * ray.direction.x();
  const double y = ray.origin.y() + distance * ray.direction.y();
  if (std::abs(x) > 0.5 * rectangle.width || std::abs(y) > 0.5 * rectangle.height) {
    return std::nullopt;
  }
  return Hit{distance, 0};
}

Surface surface_at(const Box& box, int face, const Vector3& point) {
  const auto [right, down] = face_axes(face);
  const double size_u = right.cwiseAbs().dot(box.size);
  const double size_v = down.cwiseAbs().dot(box.size);
  return {right.cross(-down),
          right,
          down,
          right.dot(point) + 0.5 * size_u,
          down.dot(point) + 0.5 * size_v,
          size_u,
          size_v};
}

Surface surface_at(const Rectangle& rectangle, int face, const Vector3& point) {
  static_cast<void>(face);  // there is only one
  return {-Vector3::UnitZ(),
          Vector3::UnitX(),
          Vector3::UnitY(),
          point.x() + 0.5 * rectangle.width,
          point.y() + 0.5 * rectangle.height,
          rectangle.width,
          rectangle.height};
}

Vector3 half_extent(const Box& box) { return 0.5 * box.size; }

Vector3 half_extent(const Rectangle& rectangle) {
  return {0.5 * rectangle.width, 0.5 * rectangle.height, 0};
}

double distance(const Box& box, const Vector3& point) {
  return (point.cwiseAbs() - half_extent(box)).cwiseMax(0).norm();
}

double distance(const Rectangle& rectangle, const Vector3& point) {
  return (point.cwiseAbs() - half_extent(rectangle)).cwiseMax(0).norm();
}

}  // namespace cvo_slam::synthetic
