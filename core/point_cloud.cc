// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/core/point_cloud.h"

#include <algorithm>
#include <cmath>

namespace cvo_slam {
namespace {

/// -1 for a negative zero, too, so that a point on the rim stays where it is.
float sign_of(float value) { return std::copysign(1.0F, value); }

}  // namespace

Eigen::Vector2f to_octahedron(const Eigen::Vector3f& unit) {
  const Eigen::Vector3f p = unit / unit.cwiseAbs().sum();
  if (p.z() >= 0) return p.head<2>();
  return {(1 - std::fabs(p.y())) * sign_of(p.x()), (1 - std::fabs(p.x())) * sign_of(p.y())};
}

Eigen::Vector3f from_octahedron(const Eigen::Vector2f& point) {
  Eigen::Vector3f p(point.x(), point.y(), 1 - std::fabs(point.x()) - std::fabs(point.y()));
  if (p.z() < 0) {
    p.x() = (1 - std::fabs(point.y())) * sign_of(point.x());
    p.y() = (1 - std::fabs(point.x())) * sign_of(point.y());
  }
  return p.normalized();
}

FieldOfView::FieldOfView(const PinholeCamera& camera) : camera_(camera) {
  if (!camera.has_distortion()) return;  // a pinhole leads nothing back into the image
  constexpr double kMargin = 1.05;       // for what the radial part of the distortion leaves out
  double corner = 0;
  for (const double u : {-0.5, camera.width - 0.5}) {
    for (const double v : {-0.5, camera.height - 0.5}) {
      corner =
          std::max(corner, std::hypot((u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy));
    }
  }
  const auto& [k1, k2, p1, p2, k3] = camera.distortion;
  const PinholeCamera radial{1, 1, 1, 1, 0, 0, {k1, k2, 0, 0, k3}};
  const auto distorted = [&radial](double radius) { return radial.project({radius, 0, 1}).x(); };
  // The rays in the image are those up to its corners, or up to where the polynomial turns back.
  const double step = corner / 100;
  double radius = step;
  while (distorted(radius) < kMargin * corner && distorted(radius) > distorted(radius - step)) {
    radius += step;
  }
  max_radius2_ = radius * radius;
}

bool FieldOfView::contains(const Vector3& point) const {
  constexpr double kMinDepth = 0.1;  // [m]
  if (!(point.z() > kMinDepth)) return false;
  const double radius2 = point.head<2>().squaredNorm() / (point.z() * point.z());
  return radius2 <= max_radius2_ && camera_.contains(camera_.project(point));
}

}  // namespace cvo_slam
