// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/synthetic/world_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/synthetic/shape_internal.h"

namespace cvo_slam::synthetic {
namespace {

bool is_size(double length) { return std::isfinite(length) && length > 0; }

bool is_positive(const Box& box) { return box.size.allFinite() && (box.size.array() > 0).all(); }
bool is_positive(const Rectangle& sheet) { return is_size(sheet.width) && is_size(sheet.height); }
bool is_positive(const Cylinder& cylinder) {
  return is_size(cylinder.diameter) && is_size(cylinder.height);
}
bool is_positive(const Sphere& sphere) { return is_size(sphere.diameter); }

void check_primitive(const Primitive& primitive, std::size_t index) {
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

WorldScene scene_at(const WorldScene& scene, double seconds) {
  WorldScene snapshot = scene;
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

Nearest nearest(const WorldScene& scene, const Vector3& point) {
  Nearest result{0, std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < scene.primitives.size(); ++i) {
    const SE3& T_world_shape = scene.primitives[i].T_world_shape;
    const Vector3 local =
        T_world_shape.rotation().transpose() * (point - T_world_shape.translation());
    const double away = std::visit([&](const auto& shape) { return distance(shape, local); },
                                   scene.primitives[i].shape);
    if (away < result.distance) result = {i, away};
  }
  return result;
}

double clearance(const WorldScene& scene, const Vector3& point) {
  return nearest(scene, point).distance;
}

void check(const WorldScene& scene) {
  for (std::size_t i = 0; i < scene.primitives.size(); ++i) check_primitive(scene.primitives[i], i);
  for (const auto& light : scene.lights) {
    if (!light.position.allFinite() || !(light.power >= 0)) {
      throw OptionError("scene: a light must have a finite position and a power of 0 or more");
    }
  }
}

}  // namespace cvo_slam::synthetic
