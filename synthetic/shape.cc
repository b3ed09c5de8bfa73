// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>

#include "cvo_slam/synthetic/shape_internal.h"

namespace cvo_slam::synthetic {
namespace {

// Face 2k of a box is the one towards the positive k-th axis; face 2k + 1 is opposite.
int face_of(int axis, bool positive) { return 2 * axis + (positive ? 0 : 1); }

/// Returns the directions to the right and down of a viewer outside who faces the face.
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

// The faces of a cylinder.
constexpr int kSide = 0;
constexpr int kTop = 1;
constexpr int kBottom = 2;

struct Interval {
  double enter, leave;
};
/// Returns the interval in which a t^2 + 2 b t + c <= 0, a > 0; empty without a real root.
std::optional<Interval> between_roots(double a, double b, double c) {
  const double discriminant = b * b - a * c;
  if (discriminant < 0 || a == 0) return std::nullopt;
  // q gives one root without cancellation; the other follows from the product of the roots.
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  if (q == 0) return Interval{0, 0};
  const auto [low, high] = std::minmax({q / a, c / q});
  return Interval{low, high};
}

/// Returns the angle of a direction about z, in [0, 2 pi).
double longitude(const Vector3& point) {
  const double angle = std::atan2(point.y(), point.x());
  return angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

Surface round_side(const Cylinder& cylinder, const Vector3& point) {
  const double radius = 0.5 * cylinder.diameter;
  const Vector3 normal = Vector3(point.x(), point.y(), 0).normalized();
  return {normal,
          Vector3::UnitZ().cross(normal),
          -Vector3::UnitZ(),
          radius * longitude(point),
          0.5 * cylinder.height - point.z(),
          std::numbers::pi * cylinder.diameter,
          cylinder.height};
}

}  // namespace

std::optional<Hit> intersect(const Box& box, const Ray& ray) {
  // Slab method: the ray is inside the box while it is between all three pairs of faces. A ray
  // along a slab (inverse = inf) gives infinities. There are no branches before the miss.
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
  static_cast<void>(face);  // there is only one face
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

std::optional<Hit> intersect(const Cylinder& cylinder, const Ray& ray) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const double radius = 0.5 * cylinder.diameter;
  const auto o = ray.origin.head<2>();
  const auto d = ray.direction.head<2>();
  // The part of the ray inside the endless column, then between the two ends.
  Interval column{-kInfinity, kInfinity};
  if (d.squaredNorm() > 0) {
    const auto found = between_roots(d.squaredNorm(), o.dot(d), o.squaredNorm() - radius * radius);
    if (!found) return std::nullopt;
    column = *found;
  } else if (o.squaredNorm() > radius * radius) {
    return std::nullopt;
  }
  const double low = (-0.5 * cylinder.height - ray.origin.z()) / ray.direction.z();
  const double high = (0.5 * cylinder.height - ray.origin.z()) / ray.direction.z();
  const auto [into, out] = std::minmax({low, high});
  const double enter = std::max(column.enter, into);
  const double leave = std::min(column.leave, out);
  if (!(enter <= leave) || leave <= 0) return std::nullopt;

  const bool from_inside = enter <= 0;
  const double distance = from_inside ? leave : enter;
  if (distance == (from_inside ? column.leave : column.enter)) return Hit{distance, kSide};
  return Hit{distance, distance == high ? kTop : kBottom};
}

std::optional<Hit> intersect(const Sphere& sphere, const Ray& ray) {
  const double radius = 0.5 * sphere.diameter;
  const auto found = between_roots(ray.direction.squaredNorm(), ray.origin.dot(ray.direction),
                                   (ray.origin.norm() - radius) * (ray.origin.norm() + radius));
  if (!found || found->leave <= 0) return std::nullopt;
  return Hit{found->enter > 0 ? found->enter : found->leave, 0};
}

Surface surface_at(const Cylinder& cylinder, int face, const Vector3& point) {
  if (face == kSide) return round_side(cylinder, point);
  const double sign = face == kTop ? 1 : -1;
  const double radius = 0.5 * cylinder.diameter;
  return {sign * Vector3::UnitZ(), Vector3::UnitX(),          -sign * Vector3::UnitY(),
          point.x() + radius,      radius - sign * point.y(), cylinder.diameter,
          cylinder.diameter};
}

Surface surface_at(const Sphere& sphere, int face, const Vector3& point) {
  static_cast<void>(face);  // there is only one face
  const double radius = 0.5 * sphere.diameter;
  const Vector3 normal = point.normalized();
  const double angle = longitude(point);
  const Vector3 right(-std::sin(angle), std::cos(angle), 0);
  return {normal,
          right,
          right.cross(normal),
          radius * angle,
          radius * std::acos(std::clamp(normal.z(), -1.0, 1.0)),
          2 * std::numbers::pi * radius,
          std::numbers::pi * radius};
}

Vector3 half_extent(const Cylinder& cylinder) {
  return {0.5 * cylinder.diameter, 0.5 * cylinder.diameter, 0.5 * cylinder.height};
}

Vector3 half_extent(const Sphere& sphere) { return Vector3::Constant(0.5 * sphere.diameter); }

double distance(const Cylinder& cylinder, const Vector3& point) {
  const double beside = std::max(0.0, point.head<2>().norm() - 0.5 * cylinder.diameter);
  const double beyond = std::max(0.0, std::abs(point.z()) - 0.5 * cylinder.height);
  return std::hypot(beside, beyond);
}

double distance(const Sphere& sphere, const Vector3& point) {
  return std::max(0.0, point.norm() - 0.5 * sphere.diameter);
}

}  // namespace cvo_slam::synthetic
