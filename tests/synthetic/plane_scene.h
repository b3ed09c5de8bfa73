// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cvo_slam/synthetic/world_scene.h"

namespace cvo_slam::synthetic {

/// A large sheet in a camera's frame, lit evenly.
inline WorldScene sheet_scene(const SE3& T_camera_sheet, const Texture& texture) {
  WorldScene scene;
  scene.primitives.push_back({Rectangle{100, 100}, T_camera_sheet, texture});
  scene.ambient = 1;
  return scene;
}

inline Texture plain(double grey) {
  Texture texture;
  texture.base = LinearColor::Constant(grey);
  texture.contrast = 0;
  return texture;
}

/// A plain sheet `z` metres in front of the camera, turned by `angle` [rad] about its upright axis.
inline WorldScene plane_at(double z, double angle, double grey = 0.5) {
  return sheet_scene(SE3(so3_exp({0, angle, 0}), {0, 0, z}), plain(grey));
}

}  // namespace cvo_slam::synthetic
