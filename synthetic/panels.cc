// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <numbers>

#include "cvo_slam/synthetic/built_in_worlds_internal.h"
#include "cvo_slam/synthetic/materials_internal.h"
#include "cvo_slam/synthetic/scene_builder_internal.h"

namespace cvo_slam::synthetic {
namespace {

constexpr double kFloor = 40;        // [m]; larger than any camera of these worlds can see
constexpr double kPanelsHeight = 3;  // [m]
constexpr int kPanels = 25;

constexpr double kPanelWidth = 0.6;  // [m]
constexpr double kFold =
    35 * std::numbers::pi / 180;  // angle between each panel and the common plane
constexpr double kPitch = 50 * std::numbers::pi / 180;  // pitch of a view down to the floor
constexpr double kEyes = 0.95;  // height of the camera before the panels [m]

/// Adds panels that stand on the floor along x, in a zig-zag about y = 0.
void add_panels(SceneBuilder& builder, const Texture& texture) {
  const double step = kPanelWidth * std::cos(kFold);
  for (int i = 0; i < kPanels; ++i) {
    const double x = (i - 0.5 * (kPanels - 1)) * step;
    const double fold = i % 2 == 0 ? kFold : -kFold;
    const Vector3 forward(-std::sin(fold), std::cos(fold), 0);
    builder.sheet({x, 0, 0.5 * kPanelsHeight}, forward, kPanelWidth, kPanelsHeight, texture);
  }
}

WorldScene panel_scene(const PanelOptions& options, std::uint32_t seed) {
  SceneBuilder builder(seed);
  Texture floor = options.texture ? materials::posters() : materials::plain();
  if (options.structure) {
    Texture panel = floor;
    if (options.texture) {
      floor = materials::parquet();
    } else {
      floor.base = {0.52, 0.52, 0.52};
    }
    add_panels(builder, panel);
  }
  builder.sheet({0, 0, 0}, -Vector3::UnitZ(), kFloor, kFloor, floor);
  builder.ambient(0.55);
  builder.light({-2.2, -2.4, 3}, 2.2);
  builder.light({2.6, -3.2, 3}, 1.8);
  return builder.scene();
}

/// Returns the viewpoint of a camera that looks at the middle of the panels or of the floor.
Viewpoint middle_view(const PanelOptions& options) {
  const double distance = options.near ? 1.0 : 2.0;
  if (options.structure) return {{0, -distance, kEyes}, {0, 0, 0.8 * kEyes}};
  return {{0, -distance * std::cos(kPitch), distance * std::sin(kPitch)}, {0, 0, 0}};
}

/// Returns a closed path from side to side that keeps the view ahead, as a hand films a wall.
PathPlan panel_plan(const PanelOptions& options, std::uint32_t seed) {
  constexpr int kViewpoints = 20;
  constexpr double kDuration = 14;  // [s]
  const Viewpoint middle = middle_view(options);
  PathPlan plan{.viewpoints = {}, .duration = kDuration, .tremor = {.seed = seed}};
  for (int i = 0; i < kViewpoints; ++i) {
    const double angle = 2 * std::numbers::pi * i / kViewpoints;
    const Vector3 shift(1.1 * std::sin(angle), 0.18 * std::cos(angle) - 0.06,
                        0.12 * std::sin(2 * angle));
    const Vector3 look(0.25 * std::sin(angle + 0.8), 0, 0.08 * std::sin(2 * angle));
    plan.viewpoints.push_back({middle.position + shift, middle.target + shift + look});
  }
  return plan;
}

}  // namespace

World panel_world(const PanelOptions& options, std::uint32_t seed) {
  constexpr double kPan = 0.5;
  return {panel_scene(options, seed),
          CameraPath(panel_plan(options, seed)),
          {.view = middle_view(options), .pan = kPan}};
}

}  // namespace cvo_slam::synthetic
