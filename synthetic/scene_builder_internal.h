// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "cvo_slam/synthetic/random_internal.h"
#include "cvo_slam/synthetic/scene.h"

namespace cvo_slam::synthetic {

/// Puts primitives upright into a scene and gives each texture a seed of its own, unless it has
/// one.
class SceneBuilder {
 public:
  explicit SceneBuilder(std::uint32_t seed) : random_(seed) {}

  /// A box that stands on `bottom` (the centre of its lower face), turned by `yaw` [rad] about z.
  void box(const Vector3& bottom, const Vector3& size, const Texture& texture, double yaw = 0);
  /// A column that stands on `bottom`.
  void cylinder(const Vector3& bottom, double diameter, double height, const Texture& texture);
  void sphere(const Vector3& center, double diameter, const Texture& texture);
  /// A sheet centred at `center` that someone who looks along `forward` sees upright; with a
  /// vertical `forward`, up on the sheet is towards +y.
  void sheet(const Vector3& center, const Vector3& forward, double width, double height,
             const Texture& texture);
  void light(const Vector3& position, double power) { scene_.lights.push_back({position, power}); }
  /// Light from everywhere, as a share of white.
  void ambient(double share) { scene_.ambient = share; }

  Random& random() { return random_; }
  [[nodiscard]] const Scene& scene() const { return scene_; }

 private:
  void add(const Shape& shape, const SE3& T_world_shape, Texture texture);

  Random random_;
  Scene scene_;
};

/// The rotation of a sheet that is looked at along `forward`.
[[nodiscard]] Matrix3 facing(const Vector3& forward);

}  // namespace cvo_slam::synthetic
