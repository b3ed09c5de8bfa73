// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "cvo_slam/core/association.h"
#include "cvo_slam/render/cameras_internal.h"

namespace cvo_slam::render {
namespace {

void add_path(const Path& path, const ColorScale& scale, double unit, LineArt& art) {
  constexpr double kWidth = 3.4;  // thin lines
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

/// Four edges from the camera, its image, and a mark on the image's upper side.
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
  for (const std::size_t i : {0, 1}) art.line(corners[i], corners[4], width, kKeyframeColor);
}

/// Whether the frusta of two cameras lie so much over one another that a second one hides the first
/// and the path, and tells nothing.
bool look_alike(const SE3& a, const SE3& b, double size) {
  constexpr double kApart = 0.6;   // of the size
  constexpr double kTurned = 0.8;  // cosine of some 37 degrees
  return (a.translation() - b.translation()).norm() < kApart * size &&
         a.rotation().col(2).dot(b.rotation().col(2)) > kTurned;
}

}  // namespace

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

void add_paths(const Scene& scene, const ColorScale& scale, double unit, LineArt& art) {
  for (const Path& path : scene.paths) add_path(path, scale, unit, art);
}

void add_keyframes(const Scene& scene, const Extent& extent, double unit, LineArt& art) {
  const double size = std::clamp(0.02 * extent.size(), 0.03, 1.0);
  std::vector<SE3> drawn;
  for (const SE3& keyframe : scene.keyframes) {
    const bool is_covered = std::any_of(drawn.begin(), drawn.end(), [&](const SE3& other) {
      return look_alike(keyframe, other, size);
    });
    if (is_covered) continue;
    add_frustum(keyframe, size, unit, art);
    drawn.push_back(keyframe);
  }
}

void add_constraints(const Scene& scene, double unit, LineArt& art) {
  for (const Constraint& constraint : scene.constraints) {
    // Where there is a path it shows the odometry.
    const bool hidden = constraint.kind == EdgeKind::kOdometry && !scene.paths.empty();
    if (hidden) continue;
    const double width = constraint.kind == EdgeKind::kProximity ? 1 : 1.6;
    art.line(constraint.from, constraint.to, unit * width, color_of(constraint.kind));
  }
}

double axis_length(const Extent& extent) { return 0.06 * extent.size(); }

bool shows_axes(const Extent& extent) {
  const Vector3 origin = Vector3::Zero();  // has the coordinates 0, 0, 0 in any axes
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
