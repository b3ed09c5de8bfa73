// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "cvo_slam/synthetic/random_internal.h"
#include "cvo_slam/synthetic/world_scene.h"

namespace cvo_slam::synthetic {

/// Builds a scene of upright primitives. Each texture without a seed gets one of its own.
class SceneBuilder {
 public:
  explicit SceneBuilder(std::uint32_t seed) : random_(seed) {}

  /// Adds a box. `bottom` is the centre of its lower face, `yaw` its rotation about z [rad].
  void box(const Vector3& bottom, const Vector3& size, const Texture& texture, double yaw = 0);
  /// Adds a column. `bottom` is the centre of its lower end.
  void cylinder(const Vector3& bottom, double diameter, double height, const Texture& texture);
  void sphere(const Vector3& center, double diameter, const Texture& texture);
  /// Adds a sheet that a viewer who looks along `forward` sees upright. If `forward` is vertical,
  /// the upper side of the sheet is towards +y.
  void sheet(const Vector3& center, const Vector3& forward, double width, double height,
             const Texture& texture);
  void light(const Vector3& position, double power) { scene_.lights.push_back({position, power}); }
  /// Sets the ambient light, as a share of white.
  void ambient(double share) { scene_.ambient = share; }

  Random& random() { return random_; }
  [[nodiscard]] const WorldScene& scene() const { return scene_; }

 private:
  void add(const Shape& shape, const SE3& T_world_shape, Texture texture);

  Random random_;
  WorldScene scene_;
};

/// Returns the rotation of a sheet that is viewed along `forward`.
[[nodiscard]] Matrix3 facing(const Vector3& forward);

/// A straight wall inside a house, on the floor from one point to another [m].
struct Partition {
  static constexpr double kThickness = 0.12;      ///< [m]
  static constexpr double kOpeningHeight = 2.05;  ///< [m]

  Vector3 from, to;
  double height;                 ///< [m]
  Texture left, right;           ///< textures of its sides, as seen on the way from `from` to `to`
  std::vector<double> openings;  ///< doorways without doors: distances of their middles from `from`
  double opening_width = 1.0;    ///< [m]
};

/// Builds the wall and the frames of its openings.
void partition(SceneBuilder& builder, const Partition& wall);

}  // namespace cvo_slam::synthetic
