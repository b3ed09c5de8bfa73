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
constexpr double kEast = 3.5;
constexpr double kNorth = 2.8;
constexpr double kCeiling = 2.7;

void add_shell(SceneBuilder& builder) {
  const double middle = 0.5 * kCeiling;
  builder.sheet({0, 0, 0}, -Vector3::UnitZ(), 2 * kEast, 2 * kNorth, materials::carpet_tiles());
  builder.sheet({0, 0, kCeiling}, Vector3::UnitZ(), 2 * kEast, 2 * kNorth,
                materials::ceiling_tiles());
  Texture paint = materials::rough_paint();
  for (const double sign : {-1.0, 1.0}) {
    builder.sheet({0, sign * kNorth, middle}, sign * Vector3::UnitY(), 2 * kEast, kCeiling, paint);
    builder.sheet({sign * kEast, 0, middle}, sign * Vector3::UnitX(), 2 * kNorth, kCeiling, paint);
  }
  for (const double x : {-1.7, 1.7}) {
    for (const double y : {-1.2, 1.2}) {
      builder.box({x, y, kCeiling - 0.07}, {1.25, 0.3, 0.07}, materials::lamp());
      builder.light({x, y, kCeiling - 0.35}, 1.15);
    }
  }
}

/// Adds two desks on each side of a low wall.
void add_middle_desks(SceneBuilder& builder) {
  builder.box({0, 0, 0.3}, {3.1, 0.03, 0.85},
              {Pattern::kPlaid, {0.42, 0.50, 0.56}, {0.36, 0.44, 0.50}, 0.012, 0.5});
  for (const double sign : {-1.0, 1.0}) {
    const Wall screen(builder, {0, sign * 0.02, 0}, -sign * Vector3::UnitY());
    for (const double x : {-0.78, 0.78}) {
      workplace(screen, x, 1.5);
      office_chair(screen, x + 0.06 * sign, 0.88, builder.random().uniform(-0.5, 0.5));
    }
    screen.sheet({0.02, 0.005, 0.98}, 0.21, 0.297, materials::document());
    screen.sheet({-1.3, 0.005, 1.0}, 0.21, 0.28, materials::poster());
  }
  const Wall side(builder, {1.62, 0, 0}, -Vector3::UnitX());
  waste_bin(side, {0.5, 0.14, 0});
}

void furnish_north(SceneBuilder& builder) {
  const Wall wall(builder, {0, kNorth, 0}, Vector3::UnitY());
  filing_shelf(wall, -2.85, 1.1, 5);
  filing_shelf(wall, -1.72, 1.1, 5);
  whiteboard(wall, 0.35, 2.2, 1.1);
  wall.cabinet(0.1, 1.2, 0.72);
  paper_pile(wall, {-0.25, 0.03, 0.72}, 8);
  wall.box({0.3, 0.04, 0.72}, {0.44, 0.34, 0.2}, materials::dark_plastic());  // the printer
  wall.box({0.3, 0.08, 0.92}, {0.3, 0.22, 0.03}, materials::document());
  wall.sheet({1.85, 0.01, 1.6}, 0.6, 0.85, materials::poster());
  filing_shelf(wall, 2.8, 1.2, 4);
  plant(wall, {1.85, 0.3, 0}, 1.1);
}

void furnish_south(SceneBuilder& builder) {
  const Wall wall(builder, {0, -kNorth, 0}, -Vector3::UnitY());
  for (const double x : {-2.3, -0.4, 1.5}) wall.window(x, 1.5, 1.0, 1.25);
  wall.cabinet(-2.6, 1.3, 0.7);
  wall.cabinet(-0.9, 1.2, 0.7);
  wall.books({-2.8, 0.05, 0.7}, 0.6, 0.25, 0.28);
  binders(wall, {-0.9, 0.04, 0.7}, 0.8);
  wall.box({-2.2, 0.05, 0.7}, {0.35, 0.28, 0.22}, materials::carton());
  workplace(wall, 0.75, 1.5);
  office_chair(wall, 0.7, 0.9, 0.3);
  wall.box({2.0, 0.05, 0}, {0.5, 0.45, 0.38}, materials::carton());
  wall.box({2.03, 0.08, 0.38}, {0.4, 0.35, 0.28}, materials::carton(), 0.15);
  plant(wall, {2.8, 0.4, 0}, 1.4);
}

void furnish_east(SceneBuilder& builder) {
  const Wall wall(builder, {kEast, 0, 0}, Vector3::UnitX());
  workplace(wall, -1.0, 1.6);
  office_chair(wall, -1.0, 0.92, -0.4);
  wall.sheet({-1.0, 0.01, 1.65}, 0.84, 0.6, materials::poster());
  wall.sheet({-0.25, 0.01, 1.6}, 0.42, 0.6, materials::poster());
  wall.door(0.85);
  wall.sheet({1.65, 0.01, 1.5}, 0.3, 0.42, materials::document());
  waste_bin(wall, {0.1, 0.2, 0});
}

void furnish_west(SceneBuilder& builder) {
  const Wall wall(builder, {-kEast, 0, 0}, -Vector3::UnitX());
  workplace(wall, -0.4, 1.6);
  office_chair(wall, -0.35, 0.92, 0.2);
  wall.sheet({-0.75, 0.01, 1.62}, 0.5, 0.7, materials::poster());
  wall.sheet({-0.1, 0.01, 1.6}, 0.297, 0.42, materials::document());
  wall.sheet({0.25, 0.01, 1.66}, 0.21, 0.297, materials::document());
  filing_shelf(wall, 1.15, 1.2, 5);
  wall.box({-1.6, 0, 0}, {0.6, 0.5, 1.3}, materials::metal());  // a steel cabinet
  wall.box({-1.6, 0.5, 0.04}, {0.56, 0.015, 1.2}, materials::rough_paint());
  wall.box({-1.6, 0.06, 1.3}, {0.4, 0.35, 0.25}, materials::carton());
}

PathPlan office_plan(std::uint32_t seed) {
  constexpr int kViewpoints = 24;
  constexpr double kDuration = 24;  // [s]
  PathPlan plan{.viewpoints = {}, .duration = kDuration, .tremor = {.seed = seed}};
  for (int i = 0; i < kViewpoints; ++i) {
    const double angle = 2 * std::numbers::pi * i / kViewpoints;
    const Vector3 position(2.35 * std::cos(angle), 1.65 * std::sin(angle),
                           1.42 + 0.1 * std::sin(3 * angle));
    // The camera looks across the desks, and at times at what lies on the near ones.
    const double reach = 0.45 - 0.4 * std::cos(4 * angle);
    const Vector3 target(-reach * std::cos(angle) + 0.5 * std::sin(angle), -reach * std::sin(angle),
                         0.82 + 0.12 * std::cos(4 * angle));
    plan.viewpoints.push_back({position, target});
  }
  return plan;
}

}  // namespace

World office_world(std::uint32_t seed) {
  SceneBuilder builder(seed);
  add_shell(builder);
  add_middle_desks(builder);
  furnish_north(builder);
  furnish_south(builder);
  furnish_east(builder);
  furnish_west(builder);
  builder.ambient(0.5);
  builder.light({0, -2.2, 1.7}, 0.6);  // daylight
  // The camera stands beside the desks and looks across them.
  const Anchor anchor{.view = {{-1.9, 1.4, 1.5}, {0.1, -0.1, 0.8}}};
  return {builder.scene(), CameraPath(office_plan(seed)), anchor};
}

}  // namespace cvo_slam::synthetic
