// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/render/map_view.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/render/extent_internal.h"

namespace cvo_slam::render {
namespace {

/// Share of the picture that the scene may fill; the rest is for labels.
constexpr double kFilledShare = 0.86;

void check_size(const ViewOptions& options) {
  constexpr int kLeast = 64;
  constexpr int kMost = 4096;
  const auto [least, most] = std::minmax(options.width, options.height);
  if (least >= kLeast && most <= kMost) return;
  throw OptionError(fmt::format("picture size {}x{}: width and height must be {} to {} pixels",
                                options.width, options.height, kLeast, kMost));
}

PinholeCamera camera_of(const ViewOptions& options, double focal_length) {
  return {.width = options.width,
          .height = options.height,
          .fx = focal_length,
          .fy = focal_length,
          .cx = (options.width - 1) / 2.0,
          .cy = (options.height - 1) / 2.0};
}

/// Returns R_world_view of a view along `forward` with `up` upwards in the picture.
Matrix3 looking(const Vector3& forward, const Vector3& up) {
  const Vector3 z = forward.normalized();
  const Vector3 x = z.cross(up).normalized();
  Matrix3 rotation;
  rotation << x, z.cross(x), z;
  return rotation;
}

/// Returns the bounding box of the positions, in view coordinates.
Eigen::AlignedBox3d box_of(const std::vector<Vector3>& places, const Matrix3& R_world_view) {
  Eigen::AlignedBox3d box;
  for (const Vector3& place : places) box.extend(R_world_view.transpose() * place);
  return box;
}

MapView orthographic_view(const std::vector<Vector3>& places, const Matrix3& R_world_view,
                          const ViewOptions& options) {
  const Eigen::AlignedBox3d box = box_of(places, R_world_view);
  const Vector3 sizes = box.sizes().cwiseMax(1e-3);
  const double scale =
      kFilledShare * std::min(options.width / sizes.x(), options.height / sizes.y());
  MapView view;
  view.camera = camera_of(options, scale);
  view.orthographic = true;
  view.T_world_view = SE3(R_world_view, R_world_view * box.center());
  // The range has space for the grid behind and for stray points in front.
  const double depth = sizes.norm();
  view.near = -2 * depth;
  view.far = 2 * depth;
  return view;
}

/// A camera position from which all places fit between two planes of slope `tangent` through it.
struct Fit {
  double distance;  ///< from the origin of the places, against the axis of the view
  double offset;    ///< to the side
};

Fit fit_axis(const std::vector<Vector3>& places, int axis, double tangent) {
  double right = -1e300;
  double left = -1e300;
  for (const Vector3& place : places) {
    right = std::max(right, place[axis] - tangent * place.z());
    left = std::max(left, -place[axis] - tangent * place.z());
  }
  return {(right + left) / (2 * tangent), (right - left) / 2};
}

MapView perspective_view(std::vector<Vector3> places, const Matrix3& R_world_view,
                         const ViewOptions& options) {
  MapView view;
  // A field of view of 44 degrees: little distortion, and still an impression of depth.
  view.camera = camera_of(options, 1.25 * std::max(options.width, options.height));
  for (Vector3& place : places) place = R_world_view.transpose() * place;
  const double f = view.camera.fx;
  const Fit x = fit_axis(places, 0, kFilledShare * options.width / (2 * f));
  const Fit y = fit_axis(places, 1, kFilledShare * options.height / (2 * f));
  const Vector3 eye(x.offset, y.offset, -std::max(x.distance, y.distance));
  view.T_world_view = SE3(R_world_view, R_world_view * eye);
  double nearest = 1e300;
  for (const Vector3& place : places) nearest = std::min(nearest, place.z() - eye.z());
  view.near = std::max(nearest / 4, 1e-3);
  return view;
}

MapView corner_view(const MapScene& scene, const Extent& extent, const ViewOptions& options) {
  constexpr double kElevation = 38 / kDegrees;
  constexpr double kAzimuth = -58 / kDegrees;
  const double azimuth = kAzimuth + (options.kind == ViewKind::kTurntable ? options.azimuth : 0);
  const Vector3 from(std::cos(kElevation) * std::cos(azimuth),
                     std::cos(kElevation) * std::sin(azimuth), std::sin(kElevation));
  const Matrix3 rotation = looking(-extent.axes.place(from), extent.axes.up);
  return perspective_view(framed_places(scene, extent), rotation, options);
}

/// Returns the pose at a share of the first path; without a path, of the keyframes.
SE3 followed_pose(const MapScene& scene, double progress) {
  std::vector<SE3> poses = scene.keyframes;
  if (!scene.paths.empty() && !scene.paths[0].poses.empty()) {
    poses.clear();
    for (const auto& pose : scene.paths[0].poses) poses.push_back(pose.T_world_camera);
  }
  std::erase_if(poses, [](const SE3& pose) { return !is_drawable(pose.translation()); });
  if (poses.empty()) throw OptionError("the view 'follow' needs a trajectory; choose another view");
  const auto last = static_cast<double>(poses.size() - 1);
  return poses[static_cast<std::size_t>(std::lround(std::clamp(progress, 0.0, 1.0) * last))];
}

MapView follow_view(const MapScene& scene, const Extent& extent, const ViewOptions& options) {
  const SE3 pose = followed_pose(scene, options.progress);
  const Vector3 forward = pose.rotation().col(2);
  // The eye is behind and above the camera, far enough to show the surroundings.
  const double distance = std::clamp(0.16 * extent.size(), 0.3, 4.0);
  const Vector3 eye = pose.translation() - distance * forward + 0.4 * distance * extent.axes.up;
  const Vector3 target = pose.translation() + 1.5 * distance * forward;
  const Vector3 look = target - eye;
  // If the camera looks straight down, its own up direction is used.
  const bool steep = look.normalized().cross(extent.axes.up).norm() < 0.1;
  MapView view;
  view.camera = camera_of(options, 0.75 * std::max(options.width, options.height));
  view.T_world_view =
      SE3(looking(look, steep ? Vector3(-pose.rotation().col(1)) : extent.axes.up), eye);
  view.near = 0.1 * distance;
  return view;
}

}  // namespace

const std::vector<std::pair<std::string, ViewKind>>& view_names() {
  static const std::vector<std::pair<std::string, ViewKind>> names = {
      {"top", ViewKind::kTop}, {"front", ViewKind::kFront},   {"side", ViewKind::kSide},
      {"iso", ViewKind::kIso}, {"follow", ViewKind::kFollow}, {"turntable", ViewKind::kTurntable}};
  return names;
}

Vector3 MapView::project(const Vector3& point) const {
  const Vector3 p = T_world_view.rotation().transpose() * (point - T_world_view.translation());
  if (orthographic) return {camera.fx * p.x() + camera.cx, camera.fy * p.y() + camera.cy, p.z()};
  return {camera.fx * p.x() / p.z() + camera.cx, camera.fy * p.y() / p.z() + camera.cy, p.z()};
}

double MapView::buffer_depth(double depth) const {
  return orthographic ? (depth - near) / (far - near) : 1 - near / depth;
}

Vector3 MapView::ray(const Vector3& point) const {
  if (orthographic) return T_world_view.rotation().col(2);
  return (point - T_world_view.translation()).normalized();
}

MapView make_view(const MapScene& scene, const ViewOptions& options) {
  check_size(options);
  const Extent extent = extent_of(scene);
  const LevelAxes& axes = extent.axes;
  switch (options.kind) {
    case ViewKind::kTop:
      return orthographic_view(framed_places(scene, extent), looking(-axes.up, axes.ahead),
                               options);
    case ViewKind::kFront:
      return orthographic_view(framed_places(scene, extent), looking(axes.ahead, axes.up), options);
    case ViewKind::kSide:
      return orthographic_view(framed_places(scene, extent), looking(-axes.right, axes.up),
                               options);
    case ViewKind::kFollow:
      return follow_view(scene, extent, options);
    case ViewKind::kIso:
    case ViewKind::kTurntable:
      return corner_view(scene, extent, options);
  }
  return {};
}

MapView enlarged(const MapView& view, int factor) {
  MapView result = view;
  PinholeCamera& camera = result.camera;
  camera.width *= factor;
  camera.height *= factor;
  camera.fx *= factor;
  camera.fy *= factor;
  // Pixel centres are whole numbers: the corner of the image, at -0.5, stays in place.
  camera.cx = (camera.cx + 0.5) * factor - 0.5;
  camera.cy = (camera.cy + 0.5) * factor - 0.5;
  return result;
}

}  // namespace cvo_slam::render
