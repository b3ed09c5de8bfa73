// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/render/map_scene.h"

namespace cvo_slam::render {

/// The direction that a picture is taken from. All views are framed so that the scene fills the
/// picture.
enum class ViewKind {
  kTop,        ///< from above, orthographic
  kFront,      ///< along the horizontal axis that points ahead, orthographic
  kSide,       ///< along the horizontal axis that points to the left, orthographic
  kIso,        ///< from above a corner, perspective
  kTurntable,  ///< as kIso, turned by the azimuth of the options
  kFollow,     ///< from behind the camera at a position of its path, perspective
};

/// Returns the names that users type: top, front, ...
[[nodiscard]] const std::vector<std::pair<std::string, ViewKind>>& view_names();

/// Where a picture is taken from, and its size.
struct ViewOptions {
  ViewKind kind = ViewKind::kIso;  ///< direction of the view
  int width = 1920;                ///< [px], 64 to 4096
  int height = 1080;               ///< [px], 64 to 4096
  double azimuth = 0;  ///< turn of kTurntable about the up direction, from the corner of kIso [rad]
  double progress = 1;  ///< position of kFollow on the first path: 0 = its start, 1 = its end
};

/// A virtual camera. Pixels are those of core/camera.h: (0, 0) is the centre of the upper left one.
struct MapView {
  PinholeCamera camera;       ///< its image is the picture; without distortion
  SE3 T_world_view;           ///< its pose, relative to the origin of the scene
  bool orthographic = false;  ///< if true, fx and fy are pixels a metre at any depth
  /// What is nearer [m] is not drawn; less than 0 in an orthographic view, which shows what is
  /// behind the eye, too.
  double near = 0.01;
  double far = 1;  ///< what is farther [m] is not drawn in an orthographic view

  /// Returns the pixel of a point and its depth along the view [m]. In a perspective view the point
  /// must be in front of the camera.
  [[nodiscard]] Vector3 project(const Vector3& point) const;
  /// Returns the value of a depth [m] in the depth buffer: 0 at `near`, 1 at the far end. Over a
  /// plane it is affine in the pixels.
  [[nodiscard]] double buffer_depth(double depth) const;
  /// Returns the pixels a metre at a depth [m].
  [[nodiscard]] double scale(double depth) const {
    return orthographic ? camera.fx : camera.fx / depth;
  }
  /// Returns the direction from the eye to a point, a unit vector in the world.
  [[nodiscard]] Vector3 ray(const Vector3& point) const;
};

/// Returns the view that frames the scene. Throws OptionError for an impossible size, and for
/// kFollow without a trajectory.
[[nodiscard]] MapView make_view(const MapScene& scene, const ViewOptions& options);

/// Returns the same view with `factor` times as many pixels along and across.
[[nodiscard]] MapView enlarged(const MapView& view, int factor);

}  // namespace cvo_slam::render
