// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/io/synthetic/scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/io/synthetic/shape_internal.h"

namespace cvo_slam::synthetic {
namespace {

/// Distance to the shape's bounding box, which for boxes and rectangles is the shape itself.
double distance(const Primitive& primitive, const Vector3& point) {
  const Vector3 local = primitive.T_world_shape.inverse() * point;
  const Vector3 half =
      std::visit([](const auto& shape) { return half_extent(shape); }, primitive.shape);
  return (local.cwiseAbs() - half).cwiseMax(0).norm();
}

bool is_positive(const Box& box) { return box.size.allFinite() && (box.size.array() > 0).all(); }

bool is_positive(const Rectangle& rectangle) {
  return std::isfinite(rectangle.width) && std::isfinite(rectangle.height) && rectangle.width > 0 &&
         rectangle.height > 0;
}

void check(const Primitive& primitive, std::size_t index) {
  if (!std::visit([](const auto& shape) { return is_positive(shape); }, primitive.shape)) {
    throw OptionError(fmt::format("scene: the size of primitive {} must be positive", index));
  }
  if (!primitive.T_world_shape.matrix().allFinite()) {
    throw OptionError(fmt::format("scene: the pose of primitive {} must be finite", index));
  }
  if (primitive.swing &&
      (!primitive.swing->amplitude.allFinite() || !(primitive.swing->period > 0))) {
    throw OptionError(fmt::format(
        "scene: the swing of primitive {} must have a finite amplitude and a positive period",
        index));
  }
  if (!(primitive.texture.scale > 0)) {
    throw OptionError(
        fmt::format("scene: the texture scale of primitive {} must be positive", index));
  }
}

}  // namespace

Scene scene_at(const Scene& scene, double seconds) {
  Scene snapshot = scene;
  for (auto& primitive : snapshot.primitives) {
    if (!primitive.swing) continue;
    const Swing& swing = *primitive.swing;
    const double angle = 2 * std::numbers::pi * (seconds / swing.period + swing.phase);
    primitive.T_world_shape =
        SE3(primitive.T_world_shape.rotation(),
            primitive.T_world_shape.translation() + swing.amplitude * std::sin(angle));
    primitive.swing.reset();
  }
  return snapshot;
}

double clearance(const Scene& scene, const Vector3& point) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& primitive : scene.primitives) {
    nearest = std::min(nearest, distance(primitive, point));
  }
  return nearest;
}

void check(const Scene& scene) {
  for (std::size_t i = 0; i < scene.primitives.size(); ++i) check(scene.primitives[i], i);
  for (const auto& light : scene.lights) {
    if (!light.position.allFinite() || !(light.power >= 0)) {
      throw OptionError("scene: a light must have a finite position and a power of 0 or more");
    }
  }
}

}  // namespace cvo_slam::synthetic
