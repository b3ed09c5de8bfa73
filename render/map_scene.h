// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "cvo_slam/core/map.h"
#include "cvo_slam/core/trajectory.h"
#include "cvo_slam/plot/figure.h"

/// Pictures of maps, drawn off-screen.
namespace cvo_slam::render {

/// The trajectory of a camera, drawn as a ribbon. Missing poses interrupt it.
struct Path {
  std::string label;               ///< entry in the legend
  std::vector<StampedPose> poses;  ///< relative to the origin of the scene
  Color color = kBlue;             ///< colour of the ribbon
  /// One value a pose, or none. With values, they colour the ribbon instead of `color`;
  /// MapScene::value_label says what they are.
  std::vector<double> values = {};
};

/// A measurement between two keyframes, drawn as a line.
struct Constraint {
  ///@{
  /// Position of a keyframe, relative to the origin of the scene [m].
  Vector3 from;
  Vector3 to;
  ///@}
  EdgeKind kind = EdgeKind::kOdometry;  ///< decides the colour of the line
};

/// All that a picture of a map shows, in one world [m]. Values that are not finite or are beyond
/// kMaxCoordinate are left out of the picture; scene_notes() reports them.
struct MapScene {
  std::string title;  ///< in the upper left corner; may be empty
  /// Position in the world that all positions of the scene are relative to [m]: points are floats,
  /// which cannot tell small distances apart far from zero. The picture's axes and the numbers on
  /// its grid begin here.
  Vector3 origin = Vector3::Zero();
  std::vector<MapPoint> points;  ///< the surface
  double point_size = 0;         ///< diameter of a point [m]; 0 = estimated from the density
  std::vector<Path> paths;       ///< ViewKind::kFollow follows the first one
  std::string value_label;       ///< meaning of the paths' values, with the unit: "time [s]"
  std::vector<SE3> keyframes;    ///< T_world_camera
  /// Measurements between keyframes. Odometry is not drawn if there is a path.
  std::vector<Constraint> constraints;
  /// Up direction. The default is that of a world that is the frame of the first camera.
  Vector3 up = -Vector3::UnitY();
  bool ground = true;  ///< draws the metric grid with its numbers, and the axes of the world
};

/// Largest coordinate that is drawn, from the origin of the scene [m]. Beyond it, the 24 bits of a
/// float cannot tell positions half a metre apart.
inline constexpr double kMaxCoordinate = 1e7;

/// Makes all positions of the scene relative to another position in the world [m]. Nothing moves in
/// the world, but floats are rounded anew.
void set_origin(MapScene& scene, const Vector3& origin);

/// Returns what the picture does not show by itself, a line each: what is left out and why, and an
/// origin that is not that of the world.
[[nodiscard]] std::vector<std::string> scene_notes(const MapScene& scene);

/// Returns a scene of the map's keyframes, constraints and points, whose origin is that of the
/// points. Its up direction is that of estimate_up().
[[nodiscard]] MapScene make_scene(const Map& map);

/// Adds a path that is coloured by the seconds since its first pose, and sets `value_label`. Its
/// poses are relative to the origin of the scene.
void add_path_by_time(MapScene& scene, std::string label, std::vector<StampedPose> poses);

/// Returns the up direction of a world whose direction of gravity is not known: the direction near
/// the cameras' mean up direction that most horizontal surfaces agree on. Without poses it starts
/// from the up direction of the first camera, -y.
[[nodiscard]] Vector3 estimate_up(const std::vector<SE3>& cameras,
                                  const std::vector<MapPoint>& points);

}  // namespace cvo_slam::render
