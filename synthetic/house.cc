// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>

#include "cvo_slam/synthetic/built_in_worlds_internal.h"
#include "cvo_slam/synthetic/house_rooms_internal.h"
#include "cvo_slam/synthetic/materials_internal.h"
#include "cvo_slam/synthetic/partition_internal.h"
#include "cvo_slam/synthetic/path_styles_internal.h"

namespace cvo_slam::synthetic {
namespace {

using namespace house;

Texture paint(const Color& color) {
  Texture texture = materials::rough_paint();
  texture.base = color;
  return texture;
}

/// Floor and ceiling of a room between two corners.
void add_floor(SceneBuilder& builder, double west, double east, double south, double north,
               const Texture& floor) {
  const Vector3 middle(0.5 * (west + east), 0.5 * (south + north), 0);
  builder.sheet(middle, -Vector3::UnitZ(), east - west, north - south, floor);
  builder.sheet(middle + Vector3(0, 0, kCeiling), Vector3::UnitZ(), east - west, north - south,
                materials::rough_paint());
}

void add_floors(SceneBuilder& builder) {
  add_floor(builder, -kEnd, -kHalf, -kOuter, kOuter, materials::parquet());
  add_floor(builder, kHalf, kEnd, -kOuter, kOuter, materials::kitchen_tiles());
  add_floor(builder, -kHalf, kHalf, kInner, kOuter, materials::parquet());
  add_floor(builder, -kHalf, kHalf, -kOuter, -kInner, materials::parquet());
  add_floor(builder, -kHalf, 0, -kInner, kInner, materials::parquet());
  add_floor(builder, 0, kHalf, -kInner, kInner, materials::parquet());
}

void add_walls(SceneBuilder& builder) {
  const Texture hall = paint({0.80, 0.74, 0.60});
  const Texture living = paint({0.74, 0.78, 0.72});
  const Texture kitchen = paint({0.82, 0.80, 0.74});
  const Texture outside = materials::brickwork();
  const auto wall = [&](const Vector3& from, const Vector3& to, const Texture& left,
                        const Texture& right, std::vector<double> openings = {}) {
    partition(builder, {from, to, kCeiling, left, right, std::move(openings)});
  };
  // Around the house, against the clock: the inside is on the left.
  wall({-kEnd, -kOuter, 0}, {-kHalf, -kOuter, 0}, living, outside);
  wall({-kHalf, -kOuter, 0}, {kHalf, -kOuter, 0}, hall, outside);
  wall({kHalf, -kOuter, 0}, {kEnd, -kOuter, 0}, kitchen, outside);
  wall({kEnd, -kOuter, 0}, {kEnd, kOuter, 0}, kitchen, outside);
  wall({kEnd, kOuter, 0}, {kHalf, kOuter, 0}, kitchen, outside);
  wall({kHalf, kOuter, 0}, {-kHalf, kOuter, 0}, hall, outside);
  wall({-kHalf, kOuter, 0}, {-kEnd, kOuter, 0}, living, outside);
  wall({-kEnd, kOuter, 0}, {-kEnd, -kOuter, 0}, materials::wallpaper(), outside);
  // Between the large rooms and the corridors.
  const std::vector<double> ends = {kOuter - kAisle, kOuter + kAisle};
  wall({-kHalf, -kOuter, 0}, {-kHalf, kOuter, 0}, living, hall, ends);
  wall({kHalf, -kOuter, 0}, {kHalf, kOuter, 0}, hall, kitchen, ends);
  // Between the corridors and the rooms in the middle, each with one open door.
  wall({-kHalf, kInner, 0}, {kHalf, kInner, 0}, hall, materials::rough_paint(),
       {kHalf + kOpenDoor});
  wall({kHalf, -kInner, 0}, {-kHalf, -kInner, 0}, hall, materials::rough_paint(),
       {kHalf + kOpenDoor});
  wall({0, -kInner, 0}, {0, kInner, 0}, materials::rough_paint(), paint({0.62, 0.70, 0.78}));
}

void add_lights(SceneBuilder& builder) {
  builder.ambient(0.46);
  for (const double x : {-3.4, 3.4}) {
    for (const double y : {-kAisle, kAisle}) {
      builder.cylinder({x, y, kCeiling - 0.07}, 0.34, 0.07, materials::lamp());
      builder.light({x, y, kCeiling - 0.3}, 1.4);
    }
  }
  for (const double x : {-0.5 * (kHalf + kEnd), 0.5 * (kHalf + kEnd)}) {
    builder.cylinder({x, 0, kCeiling - 0.4}, 0.45, 0.25, materials::lamp());
    builder.cylinder({x, 0, kCeiling - 0.15}, 0.02, 0.15, materials::metal());
    builder.light({x, 0, kCeiling - 0.55}, 2.4);
  }
  for (const double x : {-2.2, 2.2}) builder.light({x, 0, 2.1}, 1.1);
}

/// From the living room eastwards through one corridor, back through the other, and on through the
/// living room past the start, up to where the first corridor is seen again.
std::vector<Vector3> corners() {
  constexpr double kEyes = 1.45;  // [m]
  constexpr double kDoor = kHalf - 0.1;
  constexpr double kTurn = kHalf + 0.8;
  constexpr double kFar = kHalf + 1.1;
  constexpr std::array<std::array<double, 2>, 17> kPlan = {{{-kFar - 0.1, -0.8},
                                                            {-kFar, 1.2},
                                                            {-kTurn, 2.6},
                                                            {-kDoor, kAisle},
                                                            {kDoor, kAisle},
                                                            {kTurn, 2.6},
                                                            {kFar, 1.2},
                                                            {kFar, -1.2},
                                                            {kTurn, -2.6},
                                                            {kDoor, -kAisle},
                                                            {-kDoor, -kAisle},
                                                            {-kTurn, -2.6},
                                                            {-kFar, -1.2},
                                                            {-kFar, 1.2},
                                                            {-kTurn, 2.6},
                                                            {-kDoor, kAisle},
                                                            {-kDoor + 1.5, kAisle}}};
  std::vector<Vector3> result;
  result.reserve(kPlan.size());
  for (const auto& [x, y] : kPlan) result.emplace_back(x, y, kEyes);
  return result;
}

PathPlan house_plan(std::uint32_t seed) {
  constexpr double kSpacing = 0.45;  // [m]
  PathPlan plan{.viewpoints = walk_along(corners(), false, kSpacing, 2.5, 0.22),
                .duration = 64,  // [s]
                .closed = false,
                .tremor = {.seed = seed}};
  return plan;
}

}  // namespace

World house_world(std::uint32_t seed) {
  SceneBuilder builder(seed);
  add_floors(builder);
  add_walls(builder);
  add_lights(builder);
  for (const double side : {1.0, -1.0}) furnish_corridor(builder, side);
  furnish_living_room(builder);
  furnish_kitchen(builder);
  furnish_study(builder);
  furnish_bedroom(builder);
  const Anchor anchor{.view = {{-7.7, -0.5, 1.45}, {-10.2, 0.3, 0.9}}};
  return {builder.scene(), CameraPath(house_plan(seed)), anchor};
}

}  // namespace cvo_slam::synthetic
