// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>

#include "cvo_slam/synthetic/clutter_internal.h"
#include "cvo_slam/synthetic/house_rooms_internal.h"
#include "cvo_slam/synthetic/materials_internal.h"
#include "cvo_slam/synthetic/partition_internal.h"

namespace cvo_slam::synthetic::house {
namespace {

constexpr double kFace = 0.5 * Partition::kThickness;  // from a wall's middle to its surface
constexpr double kMiddle = 0.5 * (kHalf + kEnd);       // of the large rooms

/// The same print each time.
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
  const std::array<Color, 3> fruit = {Color(0.75, 0.15, 0.1), Color(0.85, 0.65, 0.1),
                                      Color(0.4, 0.6, 0.15)};
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

}  // namespace

void furnish_corridor(SceneBuilder& builder, double side) {
  constexpr std::array<double, 4> kDoors = {-5.1, -1.7, 1.7, 5.1};
  constexpr std::array<double, 3> kPictures = {-3.4, 0.0, 3.4};
  const Wall outer(builder, {0, side * (kOuter - kFace), 0}, side * Vector3::UnitY());
  const Wall inner(builder, {0, side * (kInner + kFace), 0}, -side * Vector3::UnitY());
  // What tells one corridor from the other: the plates beside the doors and the inner wall's
  // prints.
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

}  // namespace cvo_slam::synthetic::house
