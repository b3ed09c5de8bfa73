// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/LU>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/options.h"
#include "cvo_slam/io/yaml_value.h"
#include "cvo_slam/synthetic/materials_internal.h"
#include "cvo_slam/synthetic/path_planning_internal.h"
#include "cvo_slam/synthetic/random_internal.h"
#include "cvo_slam/synthetic/scene_builder_internal.h"
#include "cvo_slam/synthetic/world.h"

namespace cvo_slam::synthetic {
namespace {

// The functions below read the values of world files. They throw InputError with the line of the
// value if it is something else; `what` names it in the message.

double number_in(const YamlValue& value, const std::string& what, double low, double high) {
  const double number = value.number(what);
  if (number < low || number > high) {
    value.fail(fmt::format("{}: {} must be in [{}, {}]", what, number, low, high));
  }
  return number;
}

/// Largest length and coordinate [m]. A path through a larger world has too many viewpoints.
constexpr double kLargestLength = 1e4;

double positive(const YamlValue& value, const std::string& what) {
  const double number = value.number(what);
  if (number <= 0) value.fail(fmt::format("{}: {} must be positive", what, number));
  return number;
}

double not_negative(const YamlValue& value, const std::string& what) {
  const double number = value.number(what);
  if (number < 0) value.fail(fmt::format("{}: {} must not be negative", what, number));
  return number;
}

Vector3 vector3(const YamlValue& value, const std::string& what) {
  const auto numbers = value.numbers(what, 3);
  return {numbers[0], numbers[1], numbers[2]};
}

/// Returns a position or a shift [m].
Vector3 length3(const YamlValue& value, const std::string& what) {
  Vector3 result = vector3(value, what);
  if ((result.array().abs() <= kLargestLength).all()) return result;
  value.fail(fmt::format("{}: coordinates must be within {} m", what, kLargestLength));
}

/// Returns `count` positive lengths [m].
std::vector<double> sizes(const YamlValue& value, const std::string& what, std::size_t count) {
  auto numbers = value.numbers(what, count);
  for (const double number : numbers) {
    if (number <= 0) value.fail(fmt::format("{}: the size {} must be positive", what, number));
    if (number > kLargestLength) {
      value.fail(fmt::format("{}: the size {} must be at most {} m", what, number, kLargestLength));
    }
  }
  return numbers;
}

std::uint32_t seed_of(const YamlValue& value) {
  constexpr double kLargest = 4294967295.0;
  const double number = number_in(value, "seed", 0, kLargest);
  const auto seed = static_cast<std::uint32_t>(number);
  if (seed != number) value.fail(fmt::format("seed: {} must be a whole number", number));
  return seed;
}

/// Returns red, green and blue in [0, 1].
LinearColor read_color(const YamlValue& value, const std::string& what) {
  LinearColor result = vector3(value, what).array();
  if ((result < 0).any() || (result > 1).any()) {
    value.fail(fmt::format("{}: red, green and blue must be in [0, 1]", what));
  }
  return result;
}

/// Returns the one of the keys that a shape has; empty if it has none.
std::string one_of(const YamlValue& value, const std::vector<std::string>& keys) {
  std::string found;
  for (const auto& key : keys) {
    if (value.find(key) == nullptr) continue;
    if (!found.empty()) {
      value.fail(fmt::format("shape: give one of {} and {}, not several",
                             fmt::join(keys.begin(), keys.end() - 1, ", "), keys.back()));
    }
    found = key;
  }
  return found;
}

/// Returns the value that a name stands for.
template <typename Value>
const Value& lookup(const std::vector<std::pair<std::string, Value>>& names, const YamlValue& value,
                    const std::string& what) {
  const std::string& name = value.word(what);
  std::vector<std::string> known;
  for (const auto& entry : names) {
    if (entry.first == name) return entry.second;
    known.push_back(entry.first);
  }
  value.fail(fmt::format("{}: '{}' is unknown; {}", what, name, suggestion(name, known)));
}

/// Reads the parts of a world file.
class WorldReader {
 public:
  WorldReader(const YamlValue& root, std::uint32_t seed)
      : root_(root), random_(seed), seed_(seed), materials_(named_materials()) {
    root_.check_keys({"ambient", "lights", "materials", "shapes", "path", "anchor"}, "world");
  }

  World read() {
    read_materials();
    const WorldScene scene = read_scene();
    const YamlValue& path_value = root_.require("path", "world");
    const CameraPath path = read_path(path_value);
    if (const auto collision = first_collision(scene, path)) {
      path_value.fail(fmt::format(
          "path: after {:.2f} s the camera is inside or nearer than {} m to the shape of line {}; "
          "move the viewpoints or the shape",
          collision->seconds, kNearestSurface, shape_lines_[collision->primitive]));
    }
    return {scene, path, read_anchor(path)};
  }

 private:
  void read_materials() {
    const YamlValue* materials = root_.find("materials");
    if (materials == nullptr) return;
    for (const auto& [name, value] : materials->map("materials")) {
      materials_.emplace_back(name, read_texture(value));
    }
    // Materials of the file come first, so that they can redefine built-in ones.
    std::rotate(materials_.begin(),
                materials_.begin() + static_cast<long>(named_materials().size()), materials_.end());
  }

  /// Returns the material of a name, or of a description, which may start from a named material.
  Texture read_texture(const YamlValue& value) {
    if (value.is_word()) return lookup(materials_, value, "material");
    value.check_keys({"like", "pattern", "base", "accent", "scale", "contrast", "quarter_turn"},
                     "material");
    Texture texture;
    if (const auto* like = value.find("like")) texture = lookup(materials_, *like, "material");
    if (const auto* pattern = value.find("pattern")) {
      texture.pattern = lookup(pattern_names(), *pattern, "pattern");
    }
    if (const auto* base = value.find("base")) texture.base = read_color(*base, "base");
    if (const auto* accent = value.find("accent")) texture.accent = read_color(*accent, "accent");
    if (const auto* scale = value.find("scale")) {
      texture.scale = number_in(*scale, "scale", 1e-4, kLargestLength);
    }
    if (const auto* contrast = value.find("contrast")) {
      texture.contrast = number_in(*contrast, "contrast", 0, 1);
    }
    if (const auto* turn = value.find("quarter_turn")) {
      texture.quarter_turn = turn->flag("quarter_turn");
    }
    return texture;
  }

  WorldScene read_scene() {
    WorldScene scene;
    if (const auto* ambient = root_.find("ambient")) {
      scene.ambient = not_negative(*ambient, "ambient");
    }
    if (const auto* lights = root_.find("lights")) {
      for (const auto& value : lights->list("lights")) {
        value.check_keys({"position", "power"}, "light");
        scene.lights.push_back({length3(value.require("position", "light"), "position"),
                                not_negative(value.require("power", "light"), "power")});
      }
    }
    for (const auto& value : root_.require("shapes", "world").list("shapes")) {
      scene.primitives.push_back(read_primitive(value));
      shape_lines_.push_back(value.line());
    }
    return scene;
  }

  Primitive read_primitive(const YamlValue& value) {
    value.check_keys({"box", "sheet", "cylinder", "sphere", "at", "on", "yaw", "facing", "rotation",
                      "material", "seed", "swing"},
                     "shape");
    Primitive primitive{
        read_shape(value), {}, read_texture(value.require("material", "shape")), {}};
    primitive.T_world_shape = SE3(read_rotation(value), read_center(value, primitive.shape));
    // A seed is drawn for every shape, so that a seed in the file does not change the others.
    const std::uint32_t drawn = random_.bits();
    const auto* seed = value.find("seed");
    primitive.texture.seed = seed != nullptr ? seed_of(*seed) : drawn;
    if (const auto* swing = value.find("swing")) {
      swing->check_keys({"amplitude", "period", "phase"}, "swing");
      primitive.swing =
          Swing{length3(swing->require("amplitude", "swing"), "amplitude"),
                number_in(swing->require("period", "swing"), "period", 0.01, kLongestPath), 0};
      if (const auto* phase = swing->find("phase")) {
        primitive.swing->phase = phase->number("phase");
      }
    }
    return primitive;
  }

  static Shape read_shape(const YamlValue& value) {
    const std::string kind = one_of(value, {"box", "sheet", "cylinder", "sphere"});
    if (kind.empty()) {
      value.fail("shape: give its kind and size: box, sheet, cylinder or sphere");
    }
    const YamlValue& size = *value.find(kind);
    if (kind == "sphere") {
      const double diameter = positive(size, kind);
      if (diameter <= kLargestLength) return Sphere{diameter};
      size.fail(
          fmt::format("{}: the size {} must be at most {} m", kind, diameter, kLargestLength));
    }
    const auto lengths = sizes(size, kind, kind == "box" ? 3 : 2);
    if (kind == "box") return Box{{lengths[0], lengths[1], lengths[2]}};
    if (kind == "sheet") return Rectangle{lengths[0], lengths[1]};
    return Cylinder{lengths[0], lengths[1]};
  }

  static Matrix3 read_rotation(const YamlValue& value) {
    static_cast<void>(one_of(value, {"yaw", "facing", "rotation"}));
    if (const auto* yaw = value.find("yaw")) return so3_exp({0, 0, yaw->number("yaw")});
    if (const auto* forward = value.find("facing")) {
      const Vector3 direction = vector3(*forward, "facing");
      if (direction.norm() < 1e-9) forward->fail("facing: the direction must not be zero");
      return facing(direction);
    }
    const auto* rotation = value.find("rotation");
    if (rotation == nullptr) return Matrix3::Identity();
    Matrix3 R;
    const auto& rows = rotation->list("rotation");
    if (rows.size() != 3) rotation->fail("rotation: expected three rows");
    for (std::size_t i = 0; i < 3; ++i) {
      R.row(static_cast<Eigen::Index>(i)) = vector3(rows[i], "rotation").transpose();
    }
    constexpr double kTolerance = 1e-9;
    if ((R * R.transpose() - Matrix3::Identity()).norm() > kTolerance || R.determinant() < 0) {
      rotation->fail("rotation: the rows must be orthonormal and right-handed");
    }
    return R;
  }

  static Vector3 read_center(const YamlValue& value, const Shape& shape) {
    const std::string key = one_of(value, {"at", "on"});
    if (key.empty()) value.fail("shape: give its position: 'at' (its centre) or 'on' (its foot)");
    Vector3 place = length3(*value.find(key), key);
    if (key == "at") return place;
    double height = 0;
    if (const auto* box = std::get_if<Box>(&shape)) height = box->size.z();
    if (const auto* cylinder = std::get_if<Cylinder>(&shape)) height = cylinder->height;
    if (const auto* sphere = std::get_if<Sphere>(&shape)) height = sphere->diameter;
    return place + Vector3(0, 0, 0.5 * height);
  }

  static Viewpoint read_viewpoint(const YamlValue& value) {
    return {length3(value.require("position", "viewpoint"), "position"),
            length3(value.require("target", "viewpoint"), "target")};
  }

  [[nodiscard]] CameraPath read_path(const YamlValue& value) const {
    value.check_keys({"duration", "closed", "speed", "tremor", "viewpoints"}, "path");
    PathPlan plan;
    plan.tremor.seed = seed_;
    plan.duration = positive(value.require("duration", "path"), "duration");
    if (const auto* closed = value.find("closed")) plan.closed = closed->flag("closed");
    if (const auto* speed = value.find("speed")) plan.speed = positive(*speed, "speed");
    if (plan.duration / plan.speed > kLongestPath) {
      value.require("duration", "path")
          .fail(fmt::format("duration: {} s at speed {} are more than a day; give a shorter path",
                            plan.duration, plan.speed));
    }
    if (const auto* tremor = value.find("tremor")) read_tremor(*tremor, plan.tremor);
    const YamlValue& viewpoints = value.require("viewpoints", "path");
    for (const auto& viewpoint : viewpoints.list("viewpoints")) {
      viewpoint.check_keys({"position", "target"}, "viewpoint");
      plan.viewpoints.push_back(read_viewpoint(viewpoint));
    }
    try {
      return CameraPath(std::move(plan));
    } catch (const OptionError& error) {
      viewpoints.fail(error.what());
    }
  }

  static void read_tremor(const YamlValue& value, Tremor& tremor) {
    value.check_keys({"translation", "rotation", "seed"}, "tremor");
    if (const auto* size = value.find("translation")) {
      tremor.translation = number_in(*size, "translation", 0, kLargestLength);
    }
    if (const auto* size = value.find("rotation")) {
      tremor.rotation = number_in(*size, "rotation", 0, std::numbers::pi);
    }
    if (const auto* seed = value.find("seed")) tremor.seed = seed_of(*seed);
  }

  [[nodiscard]] Anchor read_anchor(const CameraPath& path) const {
    Anchor anchor{.view = path.plan().viewpoints.front()};
    const auto* value = root_.find("anchor");
    if (value == nullptr) return anchor;
    value->check_keys({"position", "target", "pan"}, "anchor");
    anchor.view = read_viewpoint(*value);
    if (const auto* pan = value->find("pan")) {
      anchor.pan = number_in(*pan, "pan", 0, std::numbers::pi);
    }
    return anchor;
  }

  const YamlValue& root_;
  Random random_;
  std::uint32_t seed_;
  std::vector<std::pair<std::string, Texture>> materials_;
  std::vector<long> shape_lines_;
};

}  // namespace

World read_world(const std::filesystem::path& file, std::uint32_t seed) {
  const YamlValue root = YamlValue::read(file);
  return WorldReader(root, seed).read();
}

World parse_world(const std::string& text, const std::filesystem::path& file, std::uint32_t seed) {
  const YamlValue root = YamlValue::parse(text, file);
  return WorldReader(root, seed).read();
}

}  // namespace cvo_slam::synthetic
