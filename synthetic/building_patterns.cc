// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <numbers>

#include "cvo_slam/synthetic/box_filter_internal.h"
#include "cvo_slam/synthetic/patterns_internal.h"
#include "cvo_slam/synthetic/random_internal.h"
#include "cvo_slam/synthetic/value_noise_internal.h"

// Patterns of what houses are made of: wood, bricks, tiles.

namespace cvo_slam::synthetic {
namespace {

/// The share of a joint of width `joint` between units `period` apart [m].
double joint_share(double x, double period, double joint, double pixel) {
  return filtered_pulse(x / period + 0.5 * joint / period, joint / period, pixel / period);
}

/// The share of two joints that cross.
double crossed(double across, double along) { return across + along - across * along; }

/// Light and dark year rings that meander along the plank, in [-1, 1].
double rings(const Texture& texture, const SurfacePoint& p) {
  constexpr double kSpacing = 0.018;  // [m]
  constexpr double kStretch = 6;      // a feature is that much longer than wide
  constexpr Octaves kMeander{.largest = 0.12, .count = 3, .persistence = 0.5};
  const double pixel = std::max(p.footprint_u / kStretch, p.footprint_v);
  const double bend = value_noise(texture.seed + 1, p.u / kStretch, p.v, pixel, kMeander);
  const double phase = 2 * std::numbers::pi * (p.v / kSpacing + 4 * bend);
  return std::sin(phase) * fade(kSpacing, 2 * pixel);
}

/// Fine fibres along the plank, in [-1, 1].
double fibres(const Texture& texture, const SurfacePoint& p) {
  constexpr double kStretch = 15;
  constexpr Octaves kFibres{.largest = 0.03, .count = 4, .persistence = 0.8};
  const double pixel = std::max(p.footprint_u / kStretch, p.footprint_v);
  return value_noise(texture.seed + 2, p.u / kStretch, p.v, pixel, kFibres);
}

}  // namespace

Color wood(const Texture& texture, const SurfacePoint& p) {
  constexpr double kJoint = 0.004;  // [m]
  const auto plank = static_cast<std::int32_t>(std::floor(p.v / texture.scale));
  const double length = 7 * texture.scale;
  const double shift = length * hash_unit(texture.seed, plank, 3);
  const auto piece = static_cast<std::int32_t>(std::floor((p.u + shift) / length));
  const double tone = hash_unit(texture.seed, plank, 100 + piece) - 0.5;
  const double seam = crossed(joint_share(p.v, texture.scale, kJoint, p.footprint_v),
                              joint_share(p.u + shift, length, kJoint, p.footprint_u));

  const double share =
      std::clamp(0.4 + 0.5 * tone + 0.25 * rings(texture, p) + 0.4 * fibres(texture, p), 0.0, 1.0);
  return mix(texture.base, texture.accent, share) * (1 - 0.7 * seam);
}

Color bricks(const Texture& texture, const SurfacePoint& p) {
  const double height = texture.scale / 3;
  const double joint = texture.scale / 18;
  const auto row = static_cast<std::int32_t>(std::floor(p.v / height));
  const double u = p.u + (row % 2 != 0 ? 0.5 * texture.scale : 0.0);
  const auto column = static_cast<std::int32_t>(std::floor(u / texture.scale));
  const double mortar = crossed(joint_share(p.v, height, joint, p.footprint_v),
                                joint_share(u, texture.scale, joint, p.footprint_u));
  const double tone = 0.6 * (hash_unit(texture.seed, column, row) - 0.5);
  const Color brick = texture.base * (1 + tone * fade(height, footprint(p)));
  return mix(brick, texture.accent, mortar);
}

Color tiles(const Texture& texture, const SurfacePoint& p) {
  const double joint = texture.scale / 30;
  const double parity =
      filtered_cells(p.u / texture.scale, p.v / texture.scale, p.footprint_u / texture.scale,
                     p.footprint_v / texture.scale,
                     [](std::int32_t i, std::int32_t j) { return (i + j) % 2 == 0 ? 0.0 : 1.0; });
  const double gap = crossed(joint_share(p.u, texture.scale, joint, p.footprint_u),
                             joint_share(p.v, texture.scale, joint, p.footprint_v));
  const double share = 0.5 + (parity - 0.5) * fade(texture.scale, footprint(p));
  return mix(texture.base, texture.accent, share) * (1 - 0.6 * gap);
}

}  // namespace cvo_slam::synthetic
