// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/render/map_scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "cvo_slam/core/se3.h"
#include "cvo_slam/render/extent_internal.h"

namespace cvo_slam::render {
namespace {

/// Returns the mean of the normals within an angle of `up`; `up` itself if there are too few.
Vector3 refined_up(const Vector3& up, const std::vector<MapPoint>& points, double cosine) {
  // The mean of 10,000 normals has a hundredth of their noise.
  constexpr std::size_t kEnough = 100'000;
  const std::size_t step = 1 + points.size() / kEnough;
  Vector3 sum = Vector3::Zero();
  std::size_t looked_at = 0;
  std::size_t agreeing = 0;
  for (std::size_t i = 0; i < points.size(); i += step) {
    const Vector3 normal = unit_normal(points[i]);
    ++looked_at;
    if (!(normal.dot(up) > cosine)) continue;
    sum += normal;
    ++agreeing;
  }
  constexpr std::size_t kLeastShare = 20;  // at least one normal in so many must agree
  return kLeastShare * agreeing > looked_at ? sum.normalized() : up;
}

SE3 moved(const SE3& pose, const Vector3& by) { return {pose.rotation(), pose.translation() + by}; }

std::string left_out(std::size_t count, const char* what) {
  return fmt::format("{} {}{} left out: not finite, or beyond {:.0f} km", count, what,
                     count == 1 ? "" : "s", kMaxCoordinate / 1000);
}

}  // namespace

void set_origin(MapScene& scene, const Vector3& origin) {
  const Vector3 by = scene.origin - origin;
  scene.origin = origin;
  if (by.isZero(0)) return;
  for (MapPoint& point : scene.points) {
    point.position = (point.position.cast<double>() + by).cast<float>();
  }
  for (Path& path : scene.paths) {
    for (StampedPose& pose : path.poses) pose.T_world_camera = moved(pose.T_world_camera, by);
  }
  for (SE3& keyframe : scene.keyframes) keyframe = moved(keyframe, by);
  for (Constraint& constraint : scene.constraints) {
    constraint.from += by;
    constraint.to += by;
  }
}

std::vector<std::string> scene_notes(const MapScene& scene) {
  const auto points = std::count_if(
      scene.points.begin(), scene.points.end(),
      [](const MapPoint& point) { return !is_drawable(point.position.cast<double>()); });
  std::size_t poses = 0;
  for (const Path& path : scene.paths) {
    for (const StampedPose& pose : path.poses) {
      poses += is_drawable(pose.T_world_camera.translation()) ? 0U : 1U;
    }
  }
  std::vector<std::string> notes;
  if (points > 0) notes.push_back(left_out(static_cast<std::size_t>(points), "point"));
  if (poses > 0) notes.push_back(left_out(poses, "pose"));
  if (!scene.origin.isZero(0)) {
    notes.push_back(
        fmt::format("far from the origin: axes and numbers of the picture begin at "
                    "({:.0f}, {:.0f}, {:.0f}) m",
                    scene.origin.x(), scene.origin.y(), scene.origin.z()));
  }
  return notes;
}

Vector3 estimate_up(const std::vector<SE3>& cameras, const std::vector<MapPoint>& points) {
  Vector3 sum = Vector3::Zero();
  for (const SE3& camera : cameras) {
    if (is_drawable(camera.translation()) && camera.rotation().allFinite()) {
      sum -= camera.rotation().col(1);
    }
  }
  Vector3 up = sum.norm() > 1e-6 ? sum.normalized() : Vector3(-Vector3::UnitY());
  // The normal of the floor is in the first cone even if the cameras are tilted by 40 degrees.
  for (const double degrees : {40.0, 20.0, 10.0}) {
    up = refined_up(up, points, std::cos(degrees / kDegrees));
  }
  return up;
}

MapScene make_scene(const Map& map) {
  MapScene scene;
  for (const StampedPose& keyframe : map.keyframes) {
    scene.keyframes.push_back(keyframe.T_world_camera);
  }
  const auto& nodes = map.graph.nodes();
  if (map.keyframes.empty()) {
    for (const PoseGraphNode& node : nodes) scene.keyframes.push_back(node.T_world_node);
  }
  for (std::size_t i = 0; i < map.graph.edges().size(); ++i) {
    const auto [from, to] = map.graph.ends()[i];
    scene.constraints.push_back({nodes[from].T_world_node.translation(),
                                 nodes[to].T_world_node.translation(), map.graph.edges()[i].kind});
  }
  set_origin(scene, map.points_origin);
  scene.points = map.points;  // relative to that origin already
  scene.up = estimate_up(scene.keyframes, scene.points);
  return scene;
}

void add_path_by_time(MapScene& scene, std::string label, std::vector<StampedPose> poses) {
  Path path{std::move(label), std::move(poses), kBlue};
  for (const StampedPose& pose : path.poses) {
    path.values.push_back(seconds_between(path.poses.front().stamp, pose.stamp));
  }
  scene.value_label = "time [s]";
  scene.paths.push_back(std::move(path));
}

}  // namespace cvo_slam::render
