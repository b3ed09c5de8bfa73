// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "cvo_slam/render/extent_internal.h"
#include "cvo_slam/render/line_art_internal.h"

namespace cvo_slam::render {
namespace {

/// Of a perspective view: cuts off what is nearer than the view draws. False where nothing is left.
bool clip(const View& view, Vector3& a, Vector3& b) {
  if (view.orthographic) return true;
  const Vector3 axis = view.T_world_view.rotation().col(2);
  const double depth_a = axis.dot(a - view.T_world_view.translation());
  const double depth_b = axis.dot(b - view.T_world_view.translation());
  if (depth_a < view.near && depth_b < view.near) return false;
  if (depth_a < view.near) a += (view.near - depth_a) / (depth_b - depth_a) * (b - a);
  if (depth_b < view.near) b += (view.near - depth_b) / (depth_a - depth_b) * (a - b);
  return true;
}

}  // namespace

void LineArt::line(const Vector3& a, const Vector3& b, double width, Color color_a, Color color_b) {
  Vector3 from = a;
  Vector3 to = b;
  if (!is_drawable(from) || !is_drawable(to) || !clip(view_, from, to)) return;
  const Vector3 p = view_.project(from);
  const Vector3 q = view_.project(to);
  const Eigen::Vector2d along = (q - p).head<2>();
  if (!(along.norm() > 0)) return;
  const Eigen::Vector2d aside = width / 2 / along.norm() * Eigen::Vector2d(-along.y(), along.x());
  const auto corner = [&](const Vector3& end, double side, Color color) {
    return Corner{static_cast<float>(end.x() + side * aside.x()),
                  static_cast<float>(end.y() + side * aside.y()),
                  static_cast<float>(view_.buffer_depth(end.z())), to_bgr(color)};
  };
  for (const auto& c : {corner(p, 1, color_a), corner(p, -1, color_a), corner(q, 1, color_b),
                        corner(p, -1, color_a), corner(q, -1, color_b), corner(q, 1, color_b)}) {
    primitives_.corners.push_back(c);
  }
}

void LineArt::dot(const Vector3& place, double radius, Color color) {
  if (!is_drawable(place)) return;
  const Vector3 p = view_.project(place);
  if (!view_.orthographic && p.z() < view_.near) return;
  primitives_.splats.push_back({.x = static_cast<float>(p.x()),
                                .y = static_cast<float>(p.y()),
                                .depth = static_cast<float>(view_.buffer_depth(p.z())),
                                .radius = std::min(static_cast<float>(radius), kMaxSplatRadius),
                                .color = to_bgr(color)});
}

}  // namespace cvo_slam::render
