// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "cvo_slam/core/association.h"
#include "cvo_slam/render/extent_internal.h"
#include "cvo_slam/render/line_art_internal.h"

namespace cvo_slam::render {
namespace {

std::array<std::uint8_t, 4> to_bgr(Color color) {
  return {color.blue, color.green, color.red, 255};
}

/// Cuts off the part of a line that is nearer than a perspective view draws. Returns false if
/// nothing is left.
bool clip(const MapView& view, Vector3& a, Vector3& b) {
  if (view.orthographic) return true;
  const Vector3 axis = view.T_world_view.rotation().col(2);
  const double depth_a = axis.dot(a - view.T_world_view.translation());
  const double depth_b = axis.dot(b - view.T_world_view.translation());
  if (depth_a < view.near && depth_b < view.near) return false;
  if (depth_a < view.near) a += (view.near - depth_a) / (depth_b - depth_a) * (b - a);
  if (depth_b < view.near) b += (view.near - depth_b) / (depth_a - depth_b) * (a - b);
  return true;
}

void add_path(const Path& path, const ColorScale& scale, double unit, LineArt& art) {
  constexpr double kWidth = 3.4;  // in thin lines
  std::vector<Timestamp> stamps;
  for (const StampedPose& pose : path.poses) stamps.push_back(pose.stamp);
  const double longest_step = longest_usual_step(stamps);
  const auto color = [&](std::size_t i) {
    return i < path.values.size() ? scale(path.values[i]) : path.color;
  };
  for (std::size_t i = 0; i < path.poses.size(); ++i) {
    const Vector3& place = path.poses[i].T_world_camera.translation();
    art.dot(place, unit * kWidth / 2, color(i));
    if (i == 0 || seconds_between(stamps[i - 1], stamps[i]) > longest_step) continue;
    art.line(path.poses[i - 1].T_world_camera.translation(), place, unit * kWidth, color(i - 1),
             color(i));
  }
}

/// Draws four edges from the camera, its image, and a mark on the upper side of the image.
void add_frustum(const SE3& camera, double size, double width, LineArt& art) {
  const std::array<Vector3, 5> corners = {camera * Vector3(-0.64 * size, -0.48 * size, size),
                                          camera * Vector3(0.64 * size, -0.48 * size, size),
                                          camera * Vector3(0.64 * size, 0.48 * size, size),
                                          camera * Vector3(-0.64 * size, 0.48 * size, size),
                                          camera * Vector3(0, -0.72 * size, size)};
  for (std::size_t i = 0; i < 4; ++i) {
    art.line(camera.translation(), corners[i], width, kKeyframeColor);
    art.line(corners[i], corners[(i + 1) % 4], width, kKeyframeColor);
  }
  for (const std::size_t i : {0U, 1U}) art.line(corners[i], corners[4], width, kKeyframeColor);
}

/// Returns true if two cameras have nearly the same pose, so that the second frustum would hide the
/// first one and the path, and add nothing.
bool is_same_view(const SE3& a, const SE3& b, double size) {
  constexpr double kApart = 0.6;   // distance, in sizes of the frustum
  constexpr double kTurned = 0.8;  // cosine of about 37 degrees
  return (a.translation() - b.translation()).norm() < kApart * size &&
         a.rotation().col(2).dot(b.rotation().col(2)) > kTurned;
}

}  // namespace

ColorScale::ColorScale(const MapScene& scene) {
  for (const Path& path : scene.paths) {
    for (const double value : path.values) {
      if (!std::isfinite(value)) continue;
      min_ = std::min(min_, value);
      max_ = std::max(max_, value);
    }
  }
  cv::Mat levels(1, 256, CV_8UC1);
  // The last tenth, a pale yellow, would be invisible on a light background.
  for (int i = 0; i < levels.cols; ++i)
    levels.at<std::uint8_t>(0, i) = cv::saturate_cast<std::uint8_t>(0.9 * i);
  cv::Mat colors;
  cv::applyColorMap(levels, colors, cv::COLORMAP_PLASMA);
  for (int i = 0; i < colors.cols; ++i) {
    const auto& bgr = colors.at<cv::Vec3b>(0, i);
    table_[static_cast<std::size_t>(i)] = {bgr[2], bgr[1], bgr[0]};
  }
}

Color ColorScale::operator()(double value) const {
  if (!std::isfinite(value) || empty()) return kGrey;
  const double share = std::clamp((value - min_) / (max_ - min_), 0.0, 1.0);
  return table_[static_cast<std::size_t>(std::lround(share * 255))];
}

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

Color color_of(EdgeKind kind) {
  switch (kind) {
    case EdgeKind::kOdometry:
      return kBlue;
    case EdgeKind::kProximity:
      return kSkyBlue;
    case EdgeKind::kLoop:
      return kVermilion;
  }
  return kGrey;
}

void add_paths(const MapScene& scene, const ColorScale& scale, double unit, LineArt& art) {
  for (const Path& path : scene.paths) add_path(path, scale, unit, art);
}

void add_keyframes(const MapScene& scene, const Extent& extent, double unit, LineArt& art) {
  const double size = std::clamp(0.02 * extent.size(), 0.03, 1.0);
  std::vector<SE3> drawn;
  for (const SE3& keyframe : scene.keyframes) {
    const bool is_covered = std::any_of(drawn.begin(), drawn.end(), [&](const SE3& other) {
      return is_same_view(keyframe, other, size);
    });
    if (is_covered) continue;
    add_frustum(keyframe, size, unit, art);
    drawn.push_back(keyframe);
  }
}

void add_constraints(const MapScene& scene, double unit, LineArt& art) {
  for (const Constraint& constraint : scene.constraints) {
    // If there is a path, it shows the odometry.
    const bool hidden = constraint.kind == EdgeKind::kOdometry && !scene.paths.empty();
    if (hidden) continue;
    const double width = constraint.kind == EdgeKind::kProximity ? 1 : 1.6;
    art.line(constraint.from, constraint.to, unit * width, color_of(constraint.kind));
  }
}

double axis_length(const Extent& extent) { return 0.06 * extent.size(); }

bool shows_axes(const Extent& extent) {
  const Vector3 origin = Vector3::Zero();  // its coordinates are 0, 0, 0 in any axes
  const Vector3 margin = Vector3::Constant(0.1 * extent.size());
  return ((extent.min - margin).array() <= origin.array()).all() &&
         ((extent.max + margin).array() >= origin.array()).all();
}

void add_axes(const Extent& extent, double unit, LineArt& art) {
  if (!shows_axes(extent)) return;
  const Matrix3 ends = axis_length(extent) * Matrix3::Identity();
  for (int axis = 0; axis < 3; ++axis) {
    art.line(Vector3::Zero(), ends.col(axis), 2.2 * unit,
             kAxisColors[static_cast<std::size_t>(axis)]);
  }
}

}  // namespace cvo_slam::render
