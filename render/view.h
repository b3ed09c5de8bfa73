// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/render/scene.h"

namespace cvo_slam::render {

/// Where a picture is taken from; framed so that the scene fills it.
enum class ViewKind {
  kTop,        ///< from above, orthographic
  kFront,      ///< along the horizontal axis ahead, orthographic
  kSide,       ///< along the axis to the left, orthographic
  kIso,        ///< from above a corner, perspective
  kTurntable,  ///< as kIso, from the azimuth of the options
  kFollow,     ///< from behind the camera at some place of its path, perspective
};

/// The names that people type: top, front, ...
[[nodiscard]] const std::vector<std::pair<std::string, ViewKind>>& view_names();

struct ViewOptions {
  ViewKind kind = ViewKind::kIso;
  int width = 1920;     ///< [px], 64 to 4096
  int height = 1080;    ///< [px], 64 to 4096
  double azimuth = 0;   ///< of a turntable: turned about up against kIso's corner [rad]
  double progress = 1;  ///< of kFollow: where on the first path, 0 = its begin, 1 = its end
};

/// A virtual camera. Pixels are those of core/camera.h: (0, 0) is the centre of the upper left one.
struct View {
  PinholeCamera camera;  ///< its image is the picture; has no distortion
  SE3 T_world_view;
  bool orthographic = false;  ///< then fx and fy are pixels a metre, whatever the depth
  /// What is nearer [m] is not drawn; of an orthographic view nor is what is further than `far`.
  double near = 0.01;
  double far = 1;

  /// The pixel of a point and its depth along the view [m]. In a perspective view the point must
  /// be in front of the camera.
  [[nodiscard]] Vector3 project(const Vector3& point) const;
  /// Of a depth [m], from 0 at `near` to 1 at the far end; of planes it is affine in the pixels.
  [[nodiscard]] double buffer_depth(double depth) const;
  /// Pixels a metre at a depth [m].
  [[nodiscard]] double scale(double depth) const {
    return orthographic ? camera.fx : camera.fx / depth;
  }
  /// From the eye to a point; unit vector in the world.
  [[nodiscard]] Vector3 ray(const Vector3& point) const;
};

/// The view that frames the scene. Throws OptionError for an impossible size.
[[nodiscard]] View make_view(const Scene& scene, const ViewOptions& options);

/// The same view with `factor` times as many pixels along and across.
[[nodiscard]] View enlarged(const View& view, int factor);

}  // namespace cvo_slam::render
