// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "cvo_slam/synthetic/furniture_internal.h"
#include "cvo_slam/synthetic/materials_internal.h"

namespace cvo_slam::synthetic {

Wall::Wall(SceneBuilder& builder, const Vector3& foot, const Vector3& forward)
    : builder_(builder),
      foot_(foot),
      right_(forward.cross(Vector3::UnitZ())),
      out_(-forward),
      yaw_(std::atan2(right_.y(), right_.x())) {}

Vector3 Wall::in_world(const Vector3& at) const {
  return foot_ + at.x() * right_ + at.y() * out_ + at.z() * Vector3::UnitZ();
}

void Wall::box(const Vector3& at, const Vector3& size, const Texture& texture, double turn) const {
  builder_.box(in_world(at + Vector3(0, 0.5 * size.y(), 0)), size, texture, yaw_ + turn);
}

void Wall::cylinder(const Vector3& at, double diameter, double height,
                    const Texture& texture) const {
  builder_.cylinder(in_world(at), diameter, height, texture);
}

void Wall::sphere(const Vector3& center, double diameter, const Texture& texture) const {
  builder_.sphere(in_world(center), diameter, texture);
}

void Wall::sheet(const Vector3& center, double width, double height, const Texture& texture) const {
  builder_.sheet(in_world(center), -out_, width, height, texture);
}

void Wall::page(const Vector3& at, double width, double height) const {
  box({at.x(), at.y(), at.z() + kGap}, {width, height, kGap}, materials::paper());
}

void Wall::books(const Vector3& at, double width, double depth, double max_height) const {
  Random& random = builder_.random();
  double x = at.x() - 0.5 * width;
  while (true) {
    const double thickness = random.uniform(0.022, 0.06);
    if (x + thickness > at.x() + 0.5 * width) break;
    const double height = max_height * random.uniform(0.68, 0.97);
    const double book_depth = depth * random.uniform(0.72, 0.95);
    const LinearColor cover(random.uniform(0.08, 0.9), random.uniform(0.08, 0.8),
                            random.uniform(0.08, 0.8));
    const LinearColor print =
        cover.mean() > 0.45 ? LinearColor(0.08, 0.06, 0.05) : LinearColor(0.95, 0.88, 0.6);
    box({x + 0.5 * thickness, at.y(), at.z()}, {thickness - kGap, book_depth, height},
        {Pattern::kSpine, cover, print, 0.1, 0.2});
    const bool gap = random.uniform(0, 1) < 0.06;
    x += thickness + (gap ? random.uniform(0.05, 0.15) : 0.0);
  }
}

void Wall::bookshelf(double x, double width, double height, int boards) const {
  constexpr double kDepth = 0.28;
  const Texture side = materials::upright(materials::oak());
  for (const double sign : {-1.0, 1.0}) {
    box({x + sign * 0.5 * (width - kBoard), 0, 0}, {kBoard, kDepth, height}, side);
  }
  box({x, 0, 0}, {width - 2 * kBoard, 0.01, height}, materials::walnut());
  const double inner = width - 2 * kBoard;
  const double step = (height - kBoard) / boards;
  for (int i = 0; i <= boards; ++i) {
    const double z = i * step;
    box({x, 0.01, z}, {inner, kDepth - 0.01, kBoard}, materials::oak());
    if (i < boards) books({x, 0.02, z + kBoard}, inner - 0.02, kDepth - 0.03, step - kBoard);
  }
}

void Wall::wardrobe(double x, double width, double height) const {
  constexpr double kDepth = 0.55;
  box({x, 0, 0}, {width, kDepth, height}, materials::upright(materials::walnut()));
  for (const double sign : {-1.0, 1.0}) {
    const double door = 0.5 * width - 0.02;
    const double center = x + sign * 0.25 * width;
    box({center, kDepth, 0.08}, {door, 0.02, height - 0.12}, materials::upright(materials::oak()));
    for (const double z : {0.25, 1.15}) {
      box({center, kDepth + 0.02, z}, {door - 0.16, 0.012, 0.65},
          materials::upright(materials::walnut()));
    }
    box({x + sign * 0.05, kDepth + 0.02, 1.0}, {0.02, 0.03, 0.14}, materials::metal());
  }
  box({x - 0.25, 0.1, height}, {0.4, 0.35, 0.25}, materials::cardboard());
  box({x + 0.25, 0.08, height}, {0.35, 0.4, 0.18}, materials::cardboard());
}

void Wall::screen(const Vector3& at) const {
  box({at.x(), at.y() - 0.05, at.z()}, {0.24, 0.18, 0.015}, materials::dark_plastic());
  box({at.x(), at.y(), at.z()}, {0.05, 0.03, 0.2}, materials::dark_plastic());
  box({at.x(), at.y() + 0.03, at.z() + 0.1}, {0.56, 0.03, 0.35}, materials::dark_plastic());
  sheet({at.x(), at.y() + 0.06 + kGap, at.z() + 0.275}, 0.52, 0.31, materials::screen());
}

void Wall::desk(double x, double width) const {
  constexpr double kDepth = 0.65;
  constexpr double kHeight = 0.74;
  constexpr double kLeg = 0.05;
  box({x, 0, kHeight - kBoard}, {width, kDepth, kBoard}, materials::oak());
  for (const double sign : {-1.0, 1.0}) {
    for (const double y : {0.02, kDepth - kLeg - 0.02}) {
      box({x + sign * (0.5 * width - kLeg), y, 0}, {kLeg, kLeg, kHeight - kBoard},
          materials::metal());
    }
  }
  box({x + 0.5 * width - 0.3, 0.05, 0.05}, {0.38, 0.5, 0.6}, materials::white_paint());
  screen({x - 0.1, 0.15, kHeight});
  box({x - 0.1, 0.42, kHeight}, {0.42, 0.14, 0.02}, materials::keyboard());
  page({x - 0.5, 0.3, kHeight}, 0.21, 0.297);
  page({x + 0.33, 0.32, kHeight}, 0.21, 0.297);
  books({x + 0.5 * width - 0.2, 0.05, kHeight}, 0.34, 0.22, 0.28);
  box({x - 0.62, 0.1, kHeight}, {0.08, 0.08, 0.1},
      {Pattern::kTiles, {0.8, 0.2, 0.15}, {0.95, 0.9, 0.8}, 0.03, 0.2});
}

void Wall::bed(double x, double width) const {
  constexpr double kDepth = 0.95;
  box({x, 0, 0.05}, {width, kDepth, 0.25}, materials::walnut());
  box({x, 0.02, 0.3}, {width - 0.06, kDepth - 0.04, 0.18}, materials::linen());
  box({x + 0.2, 0.01, 0.32}, {0.65 * width, kDepth, 0.19}, materials::blanket());
  box({x - 0.5 * width + 0.28, 0.12, 0.48}, {0.4, 0.68, 0.12}, materials::linen());
  box({x - 0.5 * width, 0, 0}, {0.05, kDepth, 0.9}, materials::upright(materials::walnut()));
}

void Wall::sofa(double x, double width) const {
  const Texture cloth = materials::upholstery();
  box({x, 0, 0.05}, {width, 0.85, 0.37}, cloth);
  box({x, 0, 0.42}, {width, 0.22, 0.42}, cloth);
  for (const double sign : {-1.0, 1.0}) {
    box({x + sign * (0.5 * width - 0.09), 0.22, 0.42}, {0.18, 0.63, 0.2}, cloth);
  }
  box({x - 0.3, 0.24, 0.43}, {0.42, 0.14, 0.38}, materials::blanket());
  box({x + 0.35, 0.24, 0.43}, {0.40, 0.14, 0.36},
      {Pattern::kCarpet, {0.75, 0.45, 0.12}, {0.95, 0.88, 0.70}, 0.06, 0.4});
}

void Wall::cabinet(double x, double width, double height) const {
  constexpr double kDepth = 0.4;
  box({x, 0, 0}, {width, kDepth, height}, materials::white_paint());
  constexpr int kDrawers = 3;
  const double step = (height - 0.06) / kDrawers;
  for (int i = 0; i < kDrawers; ++i) {
    const double z = 0.04 + i * step;
    box({x, kDepth, z}, {width - 0.04, 0.015, step - 0.015}, materials::oak());
    box({x, kDepth + 0.015, z + 0.6 * step}, {0.16, 0.02, 0.02}, materials::metal());
  }
}

void Wall::window(double x, double width, double bottom, double height) const {
  constexpr double kFrame = 0.06;
  const double center = bottom + 0.5 * height;
  sheet({x, kGap, center}, width, height, materials::view());
  for (const double sign : {-1.0, 0.0, 1.0}) {
    box({x + sign * 0.5 * (width + kFrame), 0, bottom - kFrame},
        {kFrame, sign == 0 ? 0.03 : 0.05, height + 2 * kFrame}, materials::white_paint());
  }
  for (const double z : {bottom - kFrame, bottom + height}) {
    box({x, 0, z}, {width, 0.05, kFrame}, materials::white_paint());
  }
  box({x, 0, bottom - kFrame - 0.03}, {width + 0.3, 0.22, 0.03}, materials::white_paint());
}

void Wall::door(double x) const {
  constexpr double kWidth = 0.88;
  constexpr double kHeight = 2.02;
  box({x, 0, 0}, {kWidth, 0.04, kHeight}, materials::upright(materials::oak()));
  for (const double sign : {-1.0, 1.0}) {
    box({x + sign * 0.5 * (kWidth + 0.08), 0, 0}, {0.08, 0.06, kHeight}, materials::white_paint());
  }
  box({x, 0, kHeight}, {kWidth + 0.16, 0.06, 0.08}, materials::white_paint());
  for (const double z : {0.2, 1.1}) {
    box({x, 0.04, z}, {kWidth - 0.3, 0.012, 0.75}, materials::upright(materials::walnut()));
  }
  box({x + 0.5 * kWidth - 0.09, 0.04, 1.0}, {0.12, 0.05, 0.025}, materials::metal());
}

void table(SceneBuilder& builder, const Vector3& foot, const Vector3& size) {
  constexpr double kLeg = 0.05;
  const double top = size.z() - kBoard;
  builder.box(foot + Vector3(0, 0, top), {size.x(), size.y(), kBoard}, materials::walnut());
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      const Vector3 corner(x * (0.5 * size.x() - kLeg), y * (0.5 * size.y() - kLeg), 0);
      builder.box(foot + corner, {kLeg, kLeg, top}, materials::walnut());
    }
  }
  const Vector3 on_top = foot + Vector3(0, 0, size.z() + kGap);
  builder.box(on_top + Vector3(-0.05, 0.2, 0), {0.21, 0.297, kGap}, materials::paper(), 0.4);
  builder.box(on_top + Vector3(0.05, -0.22, 0), {0.24, 0.18, 0.05}, materials::cardboard(), -0.3);
  builder.box(on_top + Vector3(0.05, -0.22, 0.05), {0.2, 0.15, 0.03}, materials::poster(), 0.2);
}

}  // namespace cvo_slam::synthetic
