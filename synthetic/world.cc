// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/synthetic/world.h"

#include <algorithm>
#include <functional>

#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/options.h"
#include "cvo_slam/synthetic/built_in_worlds_internal.h"
#include "cvo_slam/synthetic/path_planning_internal.h"
#include "cvo_slam/synthetic/random_internal.h"

namespace cvo_slam::synthetic {
namespace {

struct BuiltIn {
  std::string name;
  std::function<World(std::uint32_t seed)> make;
};

const std::vector<BuiltIn>& built_in_worlds() {
  static const std::vector<BuiltIn> worlds = [] {
    std::vector<BuiltIn> all = {
        {"room", room_world}, {"office", office_world}, {"house", house_world}};
    for (const bool structure : {true, false}) {
      for (const bool texture : {true, false}) {
        for (const bool near : {true, false}) {
          all.push_back({fmt::format("{}_{}_{}", structure ? "structure" : "nostructure",
                                     texture ? "texture" : "notexture", near ? "near" : "far"),
                         [=](std::uint32_t seed) {
                           return panel_world({structure, texture, near}, seed);
                         }});
        }
      }
    }
    return all;
  }();
  return worlds;
}

World world_of(const std::string& name, std::uint32_t seed) {
  if (name.ends_with(".yaml") || name.ends_with(".yml")) return read_world(name, seed);
  for (const auto& world : built_in_worlds()) {
    if (world.name == name) return world.make(seed);
  }
  throw OptionError(
      fmt::format("scene '{}' is unknown; {}", name, suggestion(name, world_names())));
}

}  // namespace

namespace {

/// Turns a plan into that of another walk along the same way.
void vary(PathPlan& plan, std::uint32_t seed) {
  constexpr double kPosition = 0.1;  // [m]
  constexpr double kTarget = 0.2;    // [m]
  Random random(derived_seed(seed, 1));
  const auto offset = [&random](double most) {
    return Vector3(random.uniform(-most, most), random.uniform(-most, most),
                   random.uniform(-most, most));
  };
  for (Viewpoint& viewpoint : plan.viewpoints) {
    viewpoint.position += offset(kPosition);
    viewpoint.target += offset(kTarget);
  }
  plan.tremor.seed = seed;
}

}  // namespace

World make_world(const std::string& name, const WorldOptions& options) {
  World world = world_of(name, options.seed);
  if (!options.style && !options.path_seed && options.speed == 1) return world;
  PathPlan plan =
      options.style ? path_of(*options.style, world, options.seed).plan() : world.path.plan();
  plan.speed *= options.speed;
  if (options.path_seed) vary(plan, *options.path_seed);
  world.path = CameraPath(std::move(plan));
  check_path(world.scene, world.path);
  return world;
}

std::vector<std::string> world_names() {
  std::vector<std::string> names;
  for (const auto& world : built_in_worlds()) names.push_back(world.name);
  return names;
}

}  // namespace cvo_slam::synthetic
