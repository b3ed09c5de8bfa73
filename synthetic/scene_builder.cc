// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include <Eigen/Geometry>

#include "cvo_slam/synthetic/scene_builder_internal.h"

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

void SceneBuilder::add(const Shape& shape, const SE3& T_world_shape, Texture texture) {
  const std::uint32_t drawn = random_.bits();
  if (texture.seed == 0) texture.seed = drawn;
  scene_.primitives.push_back({shape, T_world_shape, texture});
}

void SceneBuilder::box(const Vector3& bottom, const Vector3& size, const Texture& texture,
                       double yaw) {
  const Vector3 center = bottom + Vector3(0, 0, 0.5 * size.z());
  add(Box{size}, SE3(so3_exp({0, 0, yaw}), center), texture);
}

void SceneBuilder::cylinder(const Vector3& bottom, double diameter, double height,
                            const Texture& texture) {
  const Vector3 center = bottom + Vector3(0, 0, 0.5 * height);
  add(Cylinder{diameter, height}, SE3(Matrix3::Identity(), center), texture);
}

void SceneBuilder::sphere(const Vector3& center, double diameter, const Texture& texture) {
  add(Sphere{diameter}, SE3(Matrix3::Identity(), center), texture);
}

void SceneBuilder::sheet(const Vector3& center, const Vector3& forward, double width, double height,
                         const Texture& texture) {
  add(Rectangle{width, height}, SE3(facing(forward), center), texture);
}

}  // namespace cvo_slam::synthetic
