// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>

#include "cvo_slam/synthetic/built_in_worlds_internal.h"
#include "cvo_slam/synthetic/furniture_internal.h"
#include "cvo_slam/synthetic/materials_internal.h"
#include "cvo_slam/synthetic/path_planning_internal.h"
#include "cvo_slam/synthetic/scene_builder_internal.h"

namespace cvo_slam::synthetic {
namespace {

// The measures of the house [m]. The x axis points east, y north.
constexpr double kCeiling = 2.5;
constexpr double kEnd = 10.75;      // outer walls in the west and east
constexpr double kHalf = 6.75;      // ends of the corridors and beginnings of the large rooms
constexpr double kOuter = 4.0;      // outer walls in the south and north
constexpr double kInner = 2.4;      // inner walls of the corridors
constexpr double kAisle = 3.2;      // middle lines of the corridors
constexpr double kOpenDoor = -1.7;  // position along each corridor, as seen from it

Texture paint(const LinearColor& color) {
  Texture texture = materials::rough_paint();
  texture.base = color;
  return texture;
}

/// Adds floor and ceiling of a room between two corners.
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
  // The outer walls, counter-clockwise: the inside is on the left.
  wall({-kEnd, -kOuter, 0}, {-kHalf, -kOuter, 0}, living, outside);
  wall({-kHalf, -kOuter, 0}, {kHalf, -kOuter, 0}, hall, outside);
  wall({kHalf, -kOuter, 0}, {kEnd, -kOuter, 0}, kitchen, outside);
  wall({kEnd, -kOuter, 0}, {kEnd, kOuter, 0}, kitchen, outside);
  wall({kEnd, kOuter, 0}, {kHalf, kOuter, 0}, kitchen, outside);
  wall({kHalf, kOuter, 0}, {-kHalf, kOuter, 0}, hall, outside);
  wall({-kHalf, kOuter, 0}, {-kEnd, kOuter, 0}, living, outside);
  wall({-kEnd, kOuter, 0}, {-kEnd, -kOuter, 0}, materials::wallpaper(), outside);
  // The walls between the large rooms and the corridors.
  const std::vector<double> ends = {kOuter - kAisle, kOuter + kAisle};
  wall({-kHalf, -kOuter, 0}, {-kHalf, kOuter, 0}, living, hall, ends);
  wall({kHalf, -kOuter, 0}, {kHalf, kOuter, 0}, hall, kitchen, ends);
  // The walls between the corridors and the rooms in the middle, each with one open door.
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

constexpr double kFace = 0.5 * Partition::kThickness;  // from the middle of a wall to its surface
constexpr double kMiddle = 0.5 * (kHalf + kEnd);       // middle of the large rooms

/// Returns a print that a seed determines.
Texture print(std::uint32_t seed) {
  Texture texture = materials::poster();
  texture.seed = seed;
  return texture;
}

void kitchen_counter(const Wall& wall, double x, double width) {
  wall.box({x, 0, 0.08}, {width, 0.58, 0.79}, materials::rough_paint());
  const int doors = static_cast<int>(width / 0.55);
  const double step = width / doors;
  for (int i = 0; i < doors; ++i) {
    const double center = x + (i + 0.5) * step - 0.5 * width;
    wall.box({center, 0.58, 0.12}, {step - 0.012, 0.018, 0.58}, materials::oak());
    wall.box({center, 0.58, 0.715}, {step - 0.012, 0.018, 0.14}, materials::oak());
    for (const double z : {0.6, 0.78}) {
      wall.box({center, 0.598, z}, {0.13, 0.02, 0.014}, materials::metal());
    }
  }
  wall.box({x, 0, 0.87}, {width + 0.02, 0.62, 0.035}, materials::walnut());
  wall.sheet({x, 0.005, 1.2}, width, 0.58, materials::kitchen_tiles());
}

void cupboards(const Wall& wall, double x, double width) {
  wall.box({x, 0, 1.5}, {width, 0.32, 0.68}, materials::rough_paint());
  const int doors = static_cast<int>(width / 0.45);
  const double step = width / doors;
  for (int i = 0; i < doors; ++i) {
    const double center = x + (i + 0.5) * step - 0.5 * width;
    wall.box({center, 0.32, 1.51}, {step - 0.012, 0.018, 0.66},
             materials::upright(materials::oak()));
    wall.box({center + 0.35 * step, 0.338, 1.56}, {0.014, 0.02, 0.13}, materials::metal());
  }
}

void on_the_counter(const Wall& wall, double x) {
  constexpr double kTop = 0.906;
  for (const double offset : {-0.9, -0.78, -0.66}) {  // jars
    wall.cylinder({x + offset, 0.12, kTop}, 0.1, 0.12 + 0.05 * (offset + 0.9) / 0.12,
                  {Pattern::kPlaid, {0.78, 0.45, 0.2}, {0.9, 0.85, 0.7}, 0.04, 0.4});
  }
  wall.cylinder({x - 0.3, 0.28, kTop}, 0.16, 0.22, materials::metal());  // the kettle
  wall.cylinder({x + 0.05, 0.3, kTop}, 0.3, 0.07, materials::ceramic());
  const std::array<LinearColor, 3> fruit = {
      LinearColor(0.75, 0.15, 0.1), LinearColor(0.85, 0.65, 0.1), LinearColor(0.4, 0.6, 0.15)};
  for (std::size_t i = 0; i < fruit.size(); ++i) {
    wall.sphere({x + 0.07 * static_cast<double>(i) - 0.02, 0.26 + 0.03 * static_cast<double>(i),
                 kTop + 0.1},
                0.085, {Pattern::kPlaster, fruit[i], fruit[i], 0.05, 0.5});
  }
  mug(wall, {x + 0.55, 0.25, kTop});
  mug(wall, {x + 0.68, 0.2, kTop});
  wall.box({x + 1.0, 0.1, kTop}, {0.46, 0.36, 0.26}, materials::dark_plastic());  // the oven
  wall.sheet({x + 0.95, 0.463, kTop + 0.13}, 0.3, 0.18, materials::screen());
}

/// Furnishes the northern corridor (side = 1) or the southern one (-1). They are the same, turned
/// by half a turn, except for the grain of their materials and some prints.
void furnish_corridor(SceneBuilder& builder, double side) {
  constexpr std::array<double, 4> kDoors = {-5.1, -1.7, 1.7, 5.1};
  constexpr std::array<double, 3> kPictures = {-3.4, 0.0, 3.4};
  const Wall outer(builder, {0, side * (kOuter - kFace), 0}, side * Vector3::UnitY());
  const Wall inner(builder, {0, side * (kInner + kFace), 0}, -side * Vector3::UnitY());
  // Only the plates beside the doors and the prints on the inner wall distinguish the corridors.
  std::uint32_t own = side > 0 ? 700 : 800;
  std::uint32_t common = 77;
  for (const double x : kDoors) {
    outer.door(x);
    outer.sheet({x + 0.66, 0.012, 1.5}, 0.14, 0.1, print(own++));
    if (-x != kOpenDoor) inner.door(x);
    inner.sheet({x + 0.66, 0.012, 1.5}, 0.14, 0.1, print(own++));
  }
  for (const double x : kPictures) {
    outer.sheet({x, 0.012, 1.55}, 0.5, 0.7, print(common++));
    inner.sheet({x, 0.012, 1.55}, 0.42, 0.6, print(own++));
  }
  outer.box({0, 0, 0}, {2 * kHalf, 0.015, 0.09}, materials::oak());
  inner.box({0, 0, 0}, {1.7, 0.24, 0.72}, materials::oak());
  for (const double x : {-0.6, 0.0, 0.6}) {  // the shoe cupboard's flaps
    inner.box({x, 0.24, 0.05}, {0.52, 0.015, 0.6}, materials::upright(materials::beech()));
    inner.box({x, 0.255, 0.55}, {0.12, 0.015, 0.02}, materials::metal());
  }
  plant(inner, {-0.6, 0.12, 0.72}, 0.3);
  paper_pile(inner, {0.1, -0.03, 0.72}, 3);
  for (const double x : {-6.2, -4.25, -2.55, -0.85, 0.85, 2.55, 4.25, 6.2}) {  // light switches
    outer.box({x, 0, 1.08}, {0.08, 0.012, 0.08}, materials::ceramic());
  }
  for (const double x : {-4.15, 4.15}) {
    outer.sheet({x, 0.012, 1.6}, 0.3, 0.4, print(common++));
  }
  builder.box({0, side * kAisle, 0}, {2 * kHalf - 1, 0.8, 0.008}, materials::rug());
}

void furnish_living_room(SceneBuilder& builder) {
  const Wall west(builder, {-kEnd + kFace, 0, 0}, -Vector3::UnitX());
  west.window(1.6, 1.8, 0.9, 1.25);
  west.sofa(-0.6, 2.0);
  west.sheet({-0.6, 0.01, 1.55}, 1.2, 0.8, materials::poster());
  west.window(-2.7, 1.2, 0.9, 1.25);
  plant(west, {0.75, 0.4, 0}, 1.3);
  table(builder, {-8.95, -0.6, 0}, {0.55, 1.0, 0.42});
  builder.box({-8.9, -0.6, 0}, {2.0, 2.6, 0.012}, materials::rug());

  const Wall south(builder, {-kMiddle, -kOuter + kFace, 0}, -Vector3::UnitY());
  south.bookshelf(0.9, 1.6, 2.0, 5);
  south.sheet({-0.4, 0.01, 1.6}, 0.5, 0.7, materials::poster());
  south.cabinet(-0.45, 0.7, 0.75);
  south.books({-0.45, 0.05, 0.75}, 0.4, 0.24, 0.27);

  const Wall north(builder, {-kMiddle, kOuter - kFace, 0}, Vector3::UnitY());
  north.cabinet(-0.7, 1.6, 0.5);
  north.box({-0.7, 0.12, 0.55}, {1.1, 0.05, 0.64}, materials::dark_plastic());  // television
  north.sheet({-0.7, 0.175, 0.87}, 1.04, 0.58, materials::view());
  north.cylinder({0.45, 0.3, 0}, 0.3, 0.03, materials::metal());  // standard lamp
  north.cylinder({0.45, 0.3, 0}, 0.03, 1.5, materials::metal());
  north.cylinder({0.45, 0.3, 1.45}, 0.38, 0.3, materials::linen());
  plant(north, {-1.75, 0.35, 0}, 1.0);

  const Wall east(builder, {-kHalf - kFace, 0, 0}, Vector3::UnitX());
  east.bookshelf(1.2, 1.7, 2.0, 5);
  east.cabinet(-1.2, 1.3, 0.8);
  east.books({-1.4, 0.05, 0.8}, 0.6, 0.26, 0.28);
  plant(east, {-0.8, 0.2, 0.8}, 0.4);
  east.sheet({-1.2, 0.01, 1.65}, 0.9, 0.6, materials::poster());
  east.sheet({0.0, 0.01, 1.6}, 0.42, 0.6, materials::poster());
}

void furnish_kitchen(SceneBuilder& builder) {
  const Wall east(builder, {kEnd - kFace, 0, 0}, Vector3::UnitX());
  kitchen_counter(east, 0.6, 3.4);
  on_the_counter(east, 0.4);
  cupboards(east, -0.2, 1.8);
  east.window(1.7, 1.1, 1.15, 0.95);
  east.box({-1.5, 0, 0}, {0.62, 0.64, 1.85}, materials::metal());  // the fridge
  east.box({-1.5, 0.64, 0.62}, {0.6, 0.02, 1.2}, materials::ceramic());
  east.sheet({-1.4, 0.665, 1.45}, 0.21, 0.297, materials::document());
  east.sheet({-1.62, 0.665, 1.5}, 0.12, 0.16, materials::poster());

  table(builder, {8.75, -2.0, 0}, {0.8, 1.3, 0.74});
  const Wall seats(builder, {8.75, -2.0, 0}, Vector3::UnitX());
  chair(seats, -0.3, 0.55, 0.15);
  chair(seats, 0.35, 0.55, -0.1);
  chair(seats, 0.0, -0.62, 3.0);

  const Wall north(builder, {kMiddle, kOuter - kFace, 0}, Vector3::UnitY());
  north.window(0.5, 1.6, 0.95, 1.2);
  north.cabinet(0.9, 1.2, 0.8);
  plant(north, {1.0, 0.2, 0.8}, 0.4);
  const Wall south(builder, {kMiddle, -kOuter + kFace, 0}, -Vector3::UnitY());
  south.window(-0.6, 1.6, 0.95, 1.2);
  south.sheet({0.9, 0.01, 1.6}, 0.6, 0.85, materials::poster());

  const Wall west(builder, {kHalf + kFace, 0, 0}, -Vector3::UnitX());
  west.bookshelf(-1.3, 1.3, 1.6, 4);
  west.cabinet(0.6, 1.4, 0.85);
  west.box({0.4, 0.05, 0.85}, {0.3, 0.25, 0.3}, materials::carton());
  mug(west, {0.9, 0.2, 0.85});
  west.sheet({0.6, 0.01, 1.6}, 0.8, 0.6, materials::poster());
  west.sheet({1.7, 0.01, 1.6}, 0.42, 0.6, materials::poster());
  waste_bin(west, {1.75, 0.2, 0});
}

void furnish_study(SceneBuilder& builder) {
  const Wall south(builder, {-0.5 * kHalf, -kInner + kFace, 0}, -Vector3::UnitY());
  south.desk(-1.4, 1.6);
  south.bookshelf(0.4, 1.6, 2.0, 5);
  south.sheet({-1.4, 0.01, 1.65}, 0.6, 0.8, materials::poster());
  const Wall east(builder, {-kFace, 0, 0}, Vector3::UnitX());
  filing_shelf(east, 0, 1.2, 4);
  chair(south, -1.4, 1.0, 0.3);
}

void furnish_bedroom(SceneBuilder& builder) {
  const Wall north(builder, {0.5 * kHalf, kInner - kFace, 0}, Vector3::UnitY());
  north.bed(-1.4, 2.0);
  north.wardrobe(0.9, 1.2, 2.0);
  north.sheet({-1.4, 0.01, 1.6}, 0.9, 0.65, materials::poster());
  const Wall west(builder, {kFace, 0, 0}, -Vector3::UnitX());
  west.cabinet(0, 1.0, 0.8);
  plant(west, {0, 0.2, 0.8}, 0.5);
}

/// Returns the corners of the path: from the living room eastwards through one corridor, back
/// through the other, and through the living room past the start until the first corridor is seen
/// again.
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
