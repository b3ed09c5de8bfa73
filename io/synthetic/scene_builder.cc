// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include <Eigen/Geometry>

#include "cvo_slam/io/synthetic/scene_builder_internal.h"

namespace cvo_slam::synthetic {

Matrix3 facing(const Vector3& forward) {
  const Vector3 z = forward.normalized();
  const bool vertical = std::abs(z.z()) > 0.999;
  const Vector3 up = vertical ? Vector3::UnitY() : Vector3::UnitZ();
  const Vector3 x = z.cross(up).normalized();
  Matrix3 R;
  R << x, z.cross(x), z;
  return R;
}

void SceneBuilder::box(const Vector3& bottom, const Vector3& size, Texture texture, double yaw) {
  texture.seed = random_.bits();
  const Vector3 center = bottom + Vector3(0, 0, 0.5 * size.z());
  scene_.primitives.push_back({Box{size}, SE3(so3_exp({0, 0, yaw}), center), texture});
}

void SceneBuilder::sheet(const Vector3& center, const Vector3& forward, double width, double height,
                         Texture texture) {
  texture.seed = random_.bits();
  scene_.primitives.push_back({Rectangle{width, height}, SE3(facing(forward), center), texture});
}

}  // namespace cvo_slam::synthetic
