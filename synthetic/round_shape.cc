// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>

#include "cvo_slam/synthetic/shape_internal.h"

// Cylinders and spheres.

namespace cvo_slam::synthetic {
namespace {

// The faces of a cylinder.
constexpr int kSide = 0;
constexpr int kTop = 1;
constexpr int kBottom = 2;

/// Where a quadratic a t^2 + 2 b t + c is not positive; empty where it has no real root.
struct Interval {
  double enter, leave;
};
std::optional<Interval> between_roots(double a, double b, double c) {
  const double discriminant = b * b - a * c;
  if (discriminant < 0 || a == 0) return std::nullopt;
  // The root without cancellation first; the other follows from the product of the roots.
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  if (q == 0) return Interval{0, 0};
  const auto [low, high] = std::minmax({q / a, c / q});
  return Interval{low, high};
}

/// The angle of a direction about z in [0, 2 pi).
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

std::optional<Hit> intersect(const Cylinder& cylinder, const Ray& ray) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const double radius = 0.5 * cylinder.diameter;
  const auto o = ray.origin.head<2>();
  const auto d = ray.direction.head<2>();
  // The part of the ray within the endless column, then within the two ends.
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
  static_cast<void>(face);  // there is only one
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
