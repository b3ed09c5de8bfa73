// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <numbers>

#include "cvo_slam/synthetic/built_in_worlds_internal.h"
#include "cvo_slam/synthetic/furniture_internal.h"
#include "cvo_slam/synthetic/materials_internal.h"

namespace cvo_slam::synthetic {
namespace {

// Half the extents of the floor, and the height of the ceiling [m].
constexpr double kEast = 2.6;
constexpr double kNorth = 2.2;
constexpr double kCeiling = 2.6;

void add_shell(SceneBuilder& builder) {
  const double middle = 0.5 * kCeiling;
  builder.sheet({0, 0, 0}, -Vector3::UnitZ(), 2 * kEast, 2 * kNorth, materials::parquet());
  builder.sheet({0, 0, kCeiling}, Vector3::UnitZ(), 2 * kEast, 2 * kNorth,
                materials::white_paint());
  Texture paint = materials::white_paint();
  paint.base = {0.78, 0.70, 0.55};
  builder.sheet({0, kNorth, middle}, Vector3::UnitY(), 2 * kEast, kCeiling, paint);
  builder.sheet({kEast, 0, middle}, Vector3::UnitX(), 2 * kNorth, kCeiling, materials::brickwork());
  builder.sheet({0, -kNorth, middle}, -Vector3::UnitY(), 2 * kEast, kCeiling,
                materials::wallpaper());
  paint.base = {0.60, 0.70, 0.76};
  builder.sheet({-kEast, 0, middle}, -Vector3::UnitX(), 2 * kNorth, kCeiling, paint);
  builder.box({0.1, 0, 0}, {2.6, 1.9, 0.012}, materials::rug());
}

void furnish_north(SceneBuilder& builder) {
  const Wall wall(builder, {0, kNorth, 0}, Vector3::UnitY());
  wall.wardrobe(-1.85, 1.2, 1.95);
  wall.desk(0.1, 1.6);
  wall.sheet({-0.35, 0.01, 1.72}, 0.6, 0.85, materials::poster());
  wall.sheet({0.45, 0.01, 1.62}, 0.42, 0.6, materials::poster());
  wall.sheet({0.95, 0.01, 1.75}, 0.3, 0.42, materials::paper());
  wall.cabinet(1.75, 0.8, 0.85);
  wall.box({1.6, 0.08, 0.85}, {0.3, 0.25, 0.22}, materials::cardboard());
  wall.books({1.98, 0.05, 0.85}, 0.3, 0.24, 0.27);
}

void furnish_east(SceneBuilder& builder) {
  const Wall wall(builder, {kEast, 0, 0}, Vector3::UnitX());
  wall.bookshelf(-0.55, 1.5, 2.0, 5);
  wall.sheet({0.85, 0.01, 1.65}, 0.7, 0.95, materials::poster());
  wall.box({0.62, 0, 0}, {0.5, 0.4, 0.4}, materials::cardboard());
  wall.box({0.58, 0.02, 0.4}, {0.36, 0.3, 0.28}, materials::cardboard());
}

void furnish_south(SceneBuilder& builder) {
  const Wall wall(builder, {0, -kNorth, 0}, -Vector3::UnitY());
  wall.bed(-1.4, 2.05);
  wall.sheet({-1.75, 0.01, 1.55}, 0.9, 0.65, materials::poster());
  wall.sheet({-0.85, 0.01, 1.6}, 0.4, 0.55, materials::poster());
  wall.cabinet(0.25, 0.5, 0.55);
  wall.books({0.2, 0.05, 0.55}, 0.3, 0.2, 0.25);
  wall.sheet({0.3, 0.01, 1.5}, 0.5, 0.7, materials::poster());
  wall.door(1.45);
}

void furnish_west(SceneBuilder& builder) {
  const Wall wall(builder, {-kEast, 0, 0}, -Vector3::UnitX());
  wall.window(0.35, 1.3, 0.95, 1.2);
  wall.sofa(-0.2, 1.9);
  wall.sheet({-1.15, 0.01, 1.6}, 0.6, 0.8, materials::poster());
  wall.box({1.5, 0, 0}, {0.45, 0.4, 0.5}, materials::cardboard());
}

WorldScene room_scene(std::uint32_t seed) {
  SceneBuilder builder(seed);
  add_shell(builder);
  furnish_north(builder);
  furnish_east(builder);
  furnish_south(builder);
  furnish_west(builder);
  table(builder, {-1.15, -0.1, 0}, {0.55, 0.9, 0.42});
  builder.box({0, 0, kCeiling - 0.12}, {0.45, 0.45, 0.12}, materials::linen());
  builder.light({0.3, 0.2, 2.2}, 1.9);
  builder.light({-2.0, -0.5, 1.6}, 0.9);  // daylight near the window
  return builder.scene();
}

PathPlan room_plan(std::uint32_t seed) {
  constexpr int kViewpoints = 14;
  constexpr double kDuration = 10;  // [s]
  std::vector<Viewpoint> viewpoints;
  for (int i = 0; i < kViewpoints; ++i) {
    const double angle = 2 * std::numbers::pi * i / kViewpoints;
    const double radius = 0.68 + 0.08 * std::cos(3 * angle);
    const Vector3 position(radius * std::cos(angle) + 0.1, radius * std::sin(angle),
                           1.3 + 0.14 * std::sin(2 * angle));
    const Vector3 target(kEast * std::cos(angle + 0.25), kNorth * std::sin(angle + 0.25),
                         0.8 + 0.25 * std::cos(3 * angle));
    viewpoints.push_back({position, target});
  }
  return {.viewpoints = viewpoints, .duration = kDuration, .tremor = {.seed = seed}};
}

}  // namespace

World room_world(std::uint32_t seed) {
  // The camera stands in the middle and looks towards the desk.
  const Anchor anchor{.view = {{0.1, -0.1, 1.35}, {0.3, kNorth, 0.85}}};
  return {room_scene(seed), CameraPath(room_plan(seed)), anchor};
}

}  // namespace cvo_slam::synthetic
