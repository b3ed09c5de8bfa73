// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cmath>
#include <numbers>

#include "cvo_slam/synthetic/furniture_internal.h"
#include "cvo_slam/synthetic/materials_internal.h"

namespace cvo_slam::synthetic {
namespace {

/// Returns a material in one of a few strong colours.
Texture painted(Random& random) {
  static const std::array<LinearColor, 6> kColors = {
      LinearColor(0.75, 0.14, 0.12), LinearColor(0.12, 0.28, 0.62), LinearColor(0.90, 0.86, 0.78),
      LinearColor(0.10, 0.45, 0.30), LinearColor(0.85, 0.62, 0.10), LinearColor(0.16, 0.16, 0.18)};
  const auto index = static_cast<std::size_t>(random.uniform(0, kColors.size() - 1e-9));
  return {Pattern::kPlaster, kColors[index], {0.9, 0.9, 0.9}, 0.05, 0.25};
}

}  // namespace

void mug(const Wall& wall, const Vector3& at) {
  Texture glaze = painted(wall.random());
  glaze.pattern = Pattern::kStripes;
  glaze.scale = 0.05;
  wall.cylinder(at, 0.082, 0.095, glaze);
  wall.box(at + Vector3(0.05, -0.008, 0.02), {0.03, 0.016, 0.055}, glaze);
}

void paper_pile(const Wall& wall, const Vector3& at, int sheets) {
  double z = at.z() + kGap;
  for (int i = 0; i < sheets; ++i) {
    Random& random = wall.random();
    const double thickness = random.uniform(0.003, 0.018);
    const Vector3 place(at.x() + random.uniform(-0.02, 0.02), at.y() + random.uniform(-0.02, 0.02),
                        z);
    const bool printed = i + 1 == sheets || random.uniform(0, 1) < 0.6;
    wall.box(place, {0.21, 0.297, thickness}, printed ? materials::document() : painted(random),
             random.uniform(-0.35, 0.35));
    z += thickness + 1e-4;
  }
}

void desk_lamp(const Wall& wall, const Vector3& at) {
  wall.cylinder(at, 0.16, 0.02, materials::dark_plastic());
  wall.cylinder(at, 0.02, 0.42, materials::metal());
  wall.box(at + Vector3(0, -0.02, 0.42), {0.03, 0.24, 0.02}, materials::metal());
  wall.cylinder(at + Vector3(0, 0.2, 0.33), 0.15, 0.1, materials::metal());
}

void plant(const Wall& wall, const Vector3& at, double height) {
  const double pot = 0.32 * height;
  wall.cylinder(at, 0.36 * height, pot,
                {Pattern::kPlaster, {0.62, 0.30, 0.18}, {0.3, 0.2, 0.1}, 0.1, 0.4});
  wall.cylinder(at + Vector3(0, 0, pot), 0.04 * height, 0.3 * height, materials::walnut());
  Random& random = wall.random();
  for (int i = 0; i < 16; ++i) {
    const double angle = random.uniform(0, 2 * std::numbers::pi);
    const double radius = random.uniform(0.04, 0.22) * height;
    const double z = random.uniform(0.42, 0.88) * height;
    wall.sphere(at + Vector3(radius * std::cos(angle), radius * std::sin(angle), z),
                random.uniform(0.1, 0.22) * height, materials::leaves());
  }
}

void waste_bin(const Wall& wall, const Vector3& at) {
  wall.cylinder(at, 0.28, 0.34,
                {Pattern::kStripes, {0.2, 0.21, 0.23}, {0.4, 0.42, 0.45}, 0.05, 0.4});
  Random& random = wall.random();
  for (int i = 0; i < 4; ++i) {
    wall.sphere(at + Vector3(random.uniform(-0.08, 0.08), random.uniform(-0.08, 0.08), 0.34),
                random.uniform(0.07, 0.1), materials::document());
  }
}

void chair(const Wall& wall, double x, double y, double turn) {
  const Vector3 away(-std::sin(turn), std::cos(turn), 0);
  const Vector3 right(std::cos(turn), std::sin(turn), 0);
  const Vector3 middle(x, y, 0);
  const auto post = [&](double across, double along, double bottom, double height) {
    wall.cylinder(middle + across * right + along * away + Vector3(0, 0, bottom), 0.035, height,
                  materials::walnut());
  };
  for (const double across : {-0.18, 0.18}) {
    for (const double along : {-0.18, 0.18}) post(across, along, 0, along > 0 ? 0.9 : 0.44);
  }
  wall.box(middle + Vector3(0, -0.21, 0.44), {0.42, 0.42, 0.03}, materials::oak(), turn);
  for (const double z : {0.6, 0.75}) {
    wall.box(middle + 0.18 * away + Vector3(0, -0.012, z), {0.38, 0.024, 0.09}, materials::oak(),
             turn);
  }
}

void office_chair(const Wall& wall, double x, double y, double turn) {
  const Vector3 away(-std::sin(turn), std::cos(turn), 0);
  const Vector3 middle(x, y, 0);
  for (int i = 0; i < 3; ++i) {  // six feet
    wall.box(middle + Vector3(0, -0.02, 0.05), {0.58, 0.04, 0.04}, materials::dark_plastic(),
             turn + i * std::numbers::pi / 3);
  }
  wall.cylinder(middle + Vector3(0, 0, 0.08), 0.06, 0.38, materials::metal());
  const Texture cloth{Pattern::kPlaid, {0.16, 0.22, 0.40}, {0.10, 0.13, 0.26}, 0.03, 0.6};
  wall.box(middle + Vector3(0, -0.235, 0.44), {0.48, 0.47, 0.08}, cloth, turn);
  wall.box(middle + 0.22 * away + Vector3(0, -0.03, 0.6), {0.44, 0.06, 0.42}, cloth, turn);
  wall.box(middle + 0.26 * away + Vector3(0, -0.01, 0.45), {0.06, 0.02, 0.3}, materials::metal(),
           turn);
}

void binders(const Wall& wall, const Vector3& at, double width) {
  constexpr double kDepth = 0.27;
  constexpr double kHeight = 0.315;
  double x = at.x() - 0.5 * width;
  while (true) {
    Random& random = wall.random();
    const double thickness = random.uniform(0, 1) < 0.6 ? 0.075 : 0.05;
    if (x + thickness > at.x() + 0.5 * width) break;
    const double center = x + 0.5 * thickness;
    const double depth = kDepth + random.uniform(-0.015, 0.015);
    wall.box({center, at.y(), at.z()}, {thickness - kGap, depth, kHeight}, painted(random));
    wall.sheet({center, at.y() + depth + kGap, at.z() + 0.2}, 0.7 * thickness, 0.15,
               {Pattern::kText, {0.92, 0.92, 0.9}, {0.1, 0.1, 0.12}, 0.022, 0.1});
    x += thickness + (random.uniform(0, 1) < 0.08 ? random.uniform(0.06, 0.16) : 0.0);
  }
}

void filing_shelf(const Wall& wall, double x, double width, int boards) {
  constexpr double kDepth = 0.36;
  constexpr double kStep = 0.38;
  const double height = boards * kStep + kBoard;
  const Texture side = materials::upright(materials::oak());
  for (const double sign : {-1.0, 1.0}) {
    wall.box({x + sign * 0.5 * (width - kBoard), 0, 0}, {kBoard, kDepth, height}, side);
  }
  wall.box({x, 0, 0}, {width - 2 * kBoard, 0.01, height}, materials::rough_paint());
  const double inner = width - 2 * kBoard;
  for (int i = 0; i <= boards; ++i) {
    const double z = i * kStep;
    wall.box({x, 0.01, z}, {inner, kDepth - 0.01, kBoard}, materials::oak());
    if (i == boards) break;
    if (i == 0) {
      wall.box({x - 0.25 * inner, 0.03, z + kBoard}, {0.4 * inner, 0.3, 0.26}, materials::carton());
      wall.box({x + 0.22 * inner, 0.03, z + kBoard}, {0.38 * inner, 0.3, 0.2}, materials::carton());
    } else if (wall.random().uniform(0, 1) < 0.6) {
      binders(wall, {x, 0.03, z + kBoard}, inner - 0.02);
    } else {
      wall.books({x, 0.03, z + kBoard}, inner - 0.02, kDepth - 0.06, kStep - 0.05);
    }
  }
  wall.box({x - 0.2 * width, 0.03, height}, {0.35 * width, 0.3, 0.22}, materials::carton());
}

void workplace(const Wall& wall, double x, double width) {
  constexpr double kDepth = 0.7;
  constexpr double kHeight = 0.74;
  constexpr double kLeg = 0.05;
  Random& random = wall.random();
  wall.box({x, 0.005, kHeight - kBoard}, {width - 0.01, kDepth, kBoard}, materials::beech());
  for (const double sign : {-1.0, 1.0}) {
    for (const double y : {0.02, kDepth - kLeg - 0.02}) {
      wall.box({x + sign * (0.5 * width - kLeg), y, 0}, {kLeg, kLeg, kHeight - kBoard},
               materials::metal());
    }
  }
  wall.box({x + 0.5 * width - 0.32, 0.08, 0.04}, {0.4, 0.55, 0.6}, materials::rough_paint());
  for (const double z : {0.22, 0.42}) {
    wall.box({x + 0.5 * width - 0.32, 0.63, z}, {0.16, 0.02, 0.02}, materials::metal());
  }
  const double middle = x + random.uniform(-0.12, 0.02);
  wall.screen({middle, 0.16, kHeight});
  wall.box({middle, 0.42, kHeight}, {0.43, 0.14, 0.02}, materials::keys(),
           random.uniform(-0.1, 0.1));
  wall.box({middle + 0.3, 0.44, kHeight}, {0.06, 0.1, 0.03}, materials::dark_plastic());
  paper_pile(wall, {x - 0.5 * width + 0.2, 0.2, kHeight}, 6);
  paper_pile(wall, {x + 0.5 * width - 0.2, 0.33, kHeight}, 3);
  wall.page({middle - 0.36, 0.4, kHeight}, 0.21, 0.297);
  mug(wall, {middle - 0.33 + random.uniform(-0.04, 0.04), 0.36, kHeight + 0.004});
  wall.books({x + 0.5 * width - 0.2, 0.03, kHeight}, 0.34, 0.24, 0.29);
  if (random.uniform(0, 1) < 0.5) {
    desk_lamp(wall, {x - 0.5 * width + 0.12, 0.12, kHeight});
  } else {
    plant(wall, {x - 0.5 * width + 0.16, 0.13, kHeight}, 0.36);
  }
}

void whiteboard(const Wall& wall, double x, double width, double height) {
  constexpr double kFoot = 0.95;
  wall.box({x, 0, kFoot}, {width, 0.02, height}, materials::metal());
  wall.sheet({x, 0.02 + kGap, kFoot + 0.5 * height}, width - 0.04, height - 0.04,
             materials::white_board());
  Texture red = materials::handwriting();
  red.accent = {0.65, 0.12, 0.10};
  red.scale = 0.08;
  const double middle = kFoot + 0.5 * height;
  wall.sheet({x - 0.27 * width, 0.02 + 2 * kGap, middle + 0.04}, 0.36 * width, 0.7 * height,
             materials::handwriting());
  wall.sheet({x + 0.12 * width, 0.02 + 2 * kGap, middle + 0.26 * height}, 0.25 * width,
             0.25 * height, red);
  wall.sheet({x + 0.3 * width, 0.02 + 2 * kGap, middle - 0.2 * height}, 0.28 * width, 0.4 * height,
             materials::handwriting());
  wall.box({x, 0.02, kFoot - 0.01}, {0.6 * width, 0.07, 0.02}, materials::metal());
  for (const double offset : {-0.2, -0.05, 0.15}) {
    wall.box({x + offset, 0.04, kFoot + 0.01}, {0.13, 0.018, 0.018}, painted(wall.random()));
  }
}

}  // namespace cvo_slam::synthetic
