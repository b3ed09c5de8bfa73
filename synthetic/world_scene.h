// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

#include "cvo_slam/core/se3.h"
#include "cvo_slam/synthetic/texture.h"

namespace cvo_slam::synthetic {

/// A solid box centred at the origin of its frame, upright along z. Each face carries the texture,
/// upright and readable from outside.
struct Box {
  Vector3 size = Vector3::Ones();  ///< [m]
};

/// A flat sheet without thickness, centred at the origin of its frame. Its axes are those of a
/// camera that looks at it: x to the right, y down, z away from the viewer. Both sides are visible.
struct Rectangle {
  double width = 1;   ///< [m]
  double height = 1;  ///< [m]
};

/// A solid column centred at the origin of its frame, upright along z. The texture of its side runs
/// around it once, upright from outside. Its ends are textured as those of a box.
struct Cylinder {
  double diameter = 1;  ///< [m]
  double height = 1;    ///< [m]
};

/// A ball centred at the origin of its frame, textured along the meridians and parallels of z.
struct Sphere {
  double diameter = 1;  ///< [m]
};

/// A new shape is added here, to the functions of shape_internal.h, to world_reader.cc and to
/// world_writer.cc.
using Shape = std::variant<Box, Rectangle, Cylinder, Sphere>;

/// A periodic motion about the rest position: the position differs from it by
/// amplitude * sin(2 pi (t / period + phase)).
struct Swing {
  Vector3 amplitude = Vector3::Zero();  ///< in the world [m]
  double period = 5;                    ///< [s]
  double phase = 0;                     ///< in periods
};

/// A textured shape in the world.
struct Primitive {
  Shape shape;                                ///< what it is, with its size
  SE3 T_world_shape;                          ///< rest position, if the shape moves
  Texture texture;                            ///< what its surface shows
  std::optional<Swing> swing = std::nullopt;  ///< empty = at rest
};

/// A lamp that shines equally in all directions and casts no shadows.
struct PointLight {
  Vector3 position = Vector3::Zero();  ///< [m]
  double power = 1;  ///< brightness of a white surface that faces the lamp at 1 m; 1 = white
};

/// All that a synthetic camera can see. The z axis of the world points up.
struct WorldScene {
  std::vector<Primitive> primitives;  ///< the textured shapes
  std::vector<PointLight> lights;     ///< their light adds up
  double ambient = 0.5;               ///< brightness of a white surface without any lamp; 1 = white
};

/// Returns the scene at one instant: all shapes are where they are at that time, and at rest.
[[nodiscard]] WorldScene scene_at(const WorldScene& scene, double seconds);

/// The surface nearest to a point.
struct Nearest {
  std::size_t primitive = 0;  ///< index in WorldScene::primitives; 0 in an empty scene, too
  double distance = 0;        ///< [m]; 0 inside a solid, infinite in an empty scene
};

/// Returns the surface nearest to a point; shapes that swing are taken at rest.
[[nodiscard]] Nearest nearest(const WorldScene& scene, const Vector3& point);

/// Returns the distance from a point to the nearest surface [m]: 0 inside a solid, infinite in an
/// empty scene.
[[nodiscard]] double clearance(const WorldScene& scene, const Vector3& point);

/// Throws OptionError, which names the primitive, for a size that is not positive or a number that
/// is not finite.
void check(const WorldScene& scene);

}  // namespace cvo_slam::synthetic
