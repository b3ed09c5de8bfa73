// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "cvo_slam/core/se3.h"
#include "cvo_slam/synthetic/texture.h"

namespace cvo_slam::synthetic {

/// A solid box centred at the origin of its frame, upright along z. Each of its faces carries the
/// texture, upright and readable from outside.
struct Box {
  Vector3 size = Vector3::Ones();  ///< [m]
};

/// A flat sheet without thickness centred at the origin of its frame. Its axes are those of a
/// camera that looks at it: x to the right, y down, z away from the viewer; seen from either side.
struct Rectangle {
  double width = 1;   ///< [m]
  double height = 1;  ///< [m]
};

/// A solid round column centred at the origin of its frame, upright along z. The texture of its
/// side runs once around, upright from outside; its ends are textured like a box's.
struct Cylinder {
  double diameter = 1;  ///< [m]
  double height = 1;    ///< [m]
};

/// A ball centred at the origin of its frame, textured along meridians and parallels of z.
struct Sphere {
  double diameter = 1;  ///< [m]
};

/// New shapes are added here, to the functions of shape_internal.h and to world_file.cc.
using Shape = std::variant<Box, Rectangle, Cylinder, Sphere>;

/// To and fro about the place of rest: the position differs from it by
/// amplitude * sin(2 pi (t / period + phase)).
struct Swing {
  Vector3 amplitude = Vector3::Zero();  ///< in the world [m]
  double period = 5;                    ///< [s]
  double phase = 0;                     ///< in periods
};

/// A textured shape somewhere in the world.
struct Primitive {
  Shape shape;
  SE3 T_world_shape;  ///< of a moving one: its place of rest
  Texture texture;
  std::optional<Swing> swing = std::nullopt;  ///< empty = at rest
};

/// A lamp that shines equally in all directions and casts no shadows.
struct PointLight {
  Vector3 position = Vector3::Zero();  ///< [m]
  double power = 1;  ///< grey level share of a white surface that faces it from one metre
};

/// What a synthetic camera can see. The z axis of the world points up.
struct Scene {
  std::vector<Primitive> primitives;
  std::vector<PointLight> lights;
  double ambient = 0.5;  ///< grey level share of a white surface without any lamp
};

/// The scene at one instant: what moves is put where it is then, and rests there.
[[nodiscard]] Scene scene_at(const Scene& scene, double seconds);

/// The surface nearest to a point.
struct Nearest {
  std::size_t primitive = 0;
  double distance = 0;  ///< 0 inside a solid, infinite in an empty scene [m]
};
[[nodiscard]] Nearest nearest(const Scene& scene, const Vector3& point);

/// Distance from a point to the nearest surface, 0 inside a solid [m]; infinite in an empty scene.
[[nodiscard]] double clearance(const Scene& scene, const Vector3& point);

/// Throws OptionError where a size is not positive, or a number not finite; names the primitive.
void check(const Scene& scene);

}  // namespace cvo_slam::synthetic
