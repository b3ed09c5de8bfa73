// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "cvo_slam/synthetic/materials_internal.h"
#include "cvo_slam/synthetic/scene_builder_internal.h"
#include "cvo_slam/synthetic/world.h"

namespace cvo_slam::synthetic {
namespace {

// fmt writes the shortest decimal number that gives the same double again.
std::string list(const Vector3& v) { return fmt::format("[{}, {}, {}]", v.x(), v.y(), v.z()); }
std::string list(const LinearColor& color) { return list(Vector3(color.matrix())); }

std::string shape_text(const Box& box) { return "box: " + list(box.size); }
std::string shape_text(const Rectangle& sheet) {
  return fmt::format("sheet: [{}, {}]", sheet.width, sheet.height);
}
std::string shape_text(const Cylinder& cylinder) {
  return fmt::format("cylinder: [{}, {}]", cylinder.diameter, cylinder.height);
}
std::string shape_text(const Sphere& sphere) { return fmt::format("sphere: {}", sphere.diameter); }

/// Returns the shortest text that gives the rotation to the last bit.
std::string rotation_text(const Matrix3& R) {
  if (R == Matrix3::Identity()) return "";
  const double yaw = std::atan2(R(1, 0), R(0, 0));
  if (so3_exp({0, 0, yaw}) == R) return fmt::format("    yaw: {}\n", yaw);
  const Vector3 forward = R.col(2);
  if (facing(forward) == R) return fmt::format("    facing: {}\n", list(forward));
  return fmt::format("    rotation: [{}, {}, {}]\n", list(Vector3(R.row(0))),
                     list(Vector3(R.row(1))), list(Vector3(R.row(2))));
}

bool equal(const Texture& a, const Texture& b) {
  return a.pattern == b.pattern && (a.base == b.base).all() && (a.accent == b.accent).all() &&
         a.scale == b.scale && a.contrast == b.contrast && a.quarter_turn == b.quarter_turn;
}

/// Returns the name of the built-in material that equals the texture; empty if there is none.
std::string name_of(const Texture& texture) {
  const auto& names = named_materials();
  const auto found = std::find_if(names.begin(), names.end(),
                                  [&](const auto& entry) { return equal(entry.second, texture); });
  return found == names.end() ? "" : found->first;
}

std::string material_text(Texture texture) {
  if (auto name = name_of(texture); !name.empty()) return name;
  const bool turned = texture.quarter_turn;
  texture.quarter_turn = false;
  const std::string turn = turned ? ", quarter_turn: true" : "";
  if (const auto name = name_of(texture); !name.empty()) {
    return fmt::format("{{like: {}{}}}", name, turn);
  }
  const auto& patterns = pattern_names();
  const auto pattern = std::find_if(patterns.begin(), patterns.end(), [&](const auto& entry) {
    return entry.second == texture.pattern;
  });
  return fmt::format("{{pattern: {}, base: {}, accent: {}, scale: {}, contrast: {}{}}}",
                     pattern->first, list(texture.base), list(texture.accent), texture.scale,
                     texture.contrast, turn);
}

std::string primitive_text(const Primitive& primitive) {
  std::string text =
      fmt::format("  - {}\n    at: {}\n{}    material: {}\n    seed: {}\n",
                  std::visit([](const auto& shape) { return shape_text(shape); }, primitive.shape),
                  list(primitive.T_world_shape.translation()),
                  rotation_text(primitive.T_world_shape.rotation()),
                  material_text(primitive.texture), primitive.texture.seed);
  if (const auto& swing = primitive.swing) {
    text += fmt::format("    swing: {{amplitude: {}, period: {}, phase: {}}}\n",
                        list(swing->amplitude), swing->period, swing->phase);
  }
  return text;
}

std::string viewpoint_text(const Viewpoint& viewpoint) {
  return fmt::format("position: {}, target: {}", list(viewpoint.position), list(viewpoint.target));
}

std::string path_text(const PathPlan& plan) {
  std::string text = fmt::format(
      "path:\n  duration: {}\n  closed: {}\n  speed: {}\n"
      "  tremor: {{translation: {}, rotation: {}, seed: {}}}\n  viewpoints:\n",
      plan.duration, plan.closed, plan.speed, plan.tremor.translation, plan.tremor.rotation,
      plan.tremor.seed);
  for (const auto& viewpoint : plan.viewpoints) {
    text += fmt::format("    - {{{}}}\n", viewpoint_text(viewpoint));
  }
  return text;
}

}  // namespace

std::string world_text(const World& world) {
  std::string text = fmt::format(
      "# A world of cvo_slam synth; the format is described in docs/reference/synthetic-worlds.md. "
      "Lengths in metres,\n"
      "# angles in radians, time in seconds; z is up.\nambient: {}\n",
      world.scene.ambient);
  text +=
      fmt::format("anchor: {{{}, pan: {}}}\n", viewpoint_text(world.anchor.view), world.anchor.pan);
  text += path_text(world.path.plan());
  if (!world.scene.lights.empty()) text += "lights:\n";
  for (const auto& light : world.scene.lights) {
    text += fmt::format("  - {{position: {}, power: {}}}\n", list(light.position), light.power);
  }
  text += world.scene.primitives.empty() ? "shapes: []\n" : "shapes:\n";
  for (const auto& primitive : world.scene.primitives) text += primitive_text(primitive);
  return text;
}

}  // namespace cvo_slam::synthetic
