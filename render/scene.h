// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "cvo_slam/core/map.h"
#include "cvo_slam/core/trajectory.h"
#include "cvo_slam/plot/figure.h"

namespace cvo_slam::render {

/// A camera's way, drawn as a ribbon. It is broken where poses are missing.
struct Path {
  std::string label;  ///< its entry in the legend
  std::vector<StampedPose> poses;
  Color color = kBlue;
  /// One a pose: then the ribbon is coloured by them in place of `color`. Scene::value_label says
  /// what they are.
  std::vector<double> values = {};
};

/// A measurement between two keyframes, drawn as a line.
struct Constraint {
  Vector3 from;
  Vector3 to;
  EdgeKind kind = EdgeKind::kOdometry;
};

/// What there is to draw, all in one world [m]. Values that are not finite or beyond
/// kMaxCoordinate are left out of the picture, and a note says so.
struct Scene {
  std::string title;
  std::vector<MapPoint> points;
  double point_size = 0;  ///< diameter of a point [m]; 0 = by the points' density
  std::vector<Path> paths;
  std::string value_label;     ///< of the paths' values, with the unit: "time [s]"
  std::vector<SE3> keyframes;  ///< T_world_camera
  std::vector<Constraint> constraints;
  /// Where up is; by default that of a world that is the first camera's frame.
  Vector3 up = -Vector3::UnitY();
  bool ground = true;  ///< the grid of metres with its numbers, and the axes
};

/// Beyond this the 24 bits of a float cannot tell places half a metre apart [m].
inline constexpr double kMaxCoordinate = 1e7;

/// What is left out of the picture, and why; a line each.
[[nodiscard]] std::vector<std::string> scene_notes(const Scene& scene);

/// The map's keyframes, constraints and points. Up is estimate_up().
[[nodiscard]] Scene make_scene(const Map& map);

/// A path coloured by the seconds since its first pose; sets `value_label`.
void add_path_by_time(Scene& scene, std::string label, std::vector<StampedPose> poses);

/// Where up is in a world that no gravity is known of: what the cameras on the mean took for it,
/// and near that the direction that most horizontal surfaces agree on. Without poses it is that of
/// the first camera, -y.
[[nodiscard]] Vector3 estimate_up(const std::vector<SE3>& cameras,
                                  const std::vector<MapPoint>& points);

}  // namespace cvo_slam::render
