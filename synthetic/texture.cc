// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/synthetic/texture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cvo_slam/synthetic/box_filter_internal.h"
#include "cvo_slam/synthetic/patterns_internal.h"
#include "cvo_slam/synthetic/random_internal.h"
#include "cvo_slam/synthetic/value_noise_internal.h"

namespace cvo_slam::synthetic {
namespace {

// Patterns of building materials: wood, bricks, tiles.

/// Returns the share of the pixel on joints of width `joint` between units `period` apart [m].
double joint_share(double x, double period, double joint, double pixel) {
  return filtered_pulse(x / period + 0.5 * joint / period, joint / period, pixel / period);
}

/// Returns the share of the pixel on joints in both directions.
double crossed(double across, double along) { return across + along - across * along; }

/// Returns light and dark year rings that meander along the plank, in [-1, 1].
double rings(const Texture& texture, const SurfacePoint& p) {
  constexpr double kSpacing = 0.018;  // [m]
  constexpr double kStretch = 6;      // ratio of length to width of a feature
  constexpr Octaves kMeander{.largest = 0.12, .count = 3, .persistence = 0.5};
  const double pixel = std::max(p.footprint_u / kStretch, p.footprint_v);
  const double bend = value_noise(texture.seed + 1, p.u / kStretch, p.v, pixel, kMeander);
  const double phase = 2 * std::numbers::pi * (p.v / kSpacing + 4 * bend);
  return std::sin(phase) * fade(kSpacing, 2 * pixel);
}

/// Returns fine fibres along the plank, in [-1, 1].
double fibres(const Texture& texture, const SurfacePoint& p) {
  constexpr double kStretch = 15;
  constexpr Octaves kFibres{.largest = 0.03, .count = 4, .persistence = 0.8};
  const double pixel = std::max(p.footprint_u / kStretch, p.footprint_v);
  return value_noise(texture.seed + 2, p.u / kStretch, p.v, pixel, kFibres);
}

// Patterns of cloth and paper that repeat along the axes: wallpaper, plaid, carpet.

/// Returns the tone of crossed threads of width `thread` [m], in [-1, 1].
double weave(const Texture& texture, double thread, const SurfacePoint& p) {
  const double tone = filtered_cells(
      p.u / thread, p.v / thread, p.footprint_u / thread, p.footprint_v / thread,
      [&](std::int32_t i, std::int32_t j) { return 2 * hash_unit(texture.seed, i, j) - 1; });
  return tone * fade(thread, 0.7 * footprint(p));
}

/// Returns a lattice of lozenges whose period is the unit of the pattern: 1 inside, 0 outside.
double lozenges(const Texture& texture, const SurfacePoint& p) {
  const double u = p.u / texture.scale;
  const double v = p.v / texture.scale;
  const double width = footprint(p) / texture.scale * std::numbers::sqrt2;
  const double rising = filtered_pulse(u + v, 0.5, width);
  const double falling = filtered_pulse(u - v, 0.5, width);
  return rising + falling - 2 * rising * falling;
}

LinearColor wood(const Texture& texture, const SurfacePoint& p) {
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

LinearColor bricks(const Texture& texture, const SurfacePoint& p) {
  const double height = texture.scale / 3;
  const double joint = texture.scale / 18;
  const auto row = static_cast<std::int32_t>(std::floor(p.v / height));
  const double u = p.u + (row % 2 != 0 ? 0.5 * texture.scale : 0.0);
  const auto column = static_cast<std::int32_t>(std::floor(u / texture.scale));
  const double mortar = crossed(joint_share(p.v, height, joint, p.footprint_v),
                                joint_share(u, texture.scale, joint, p.footprint_u));
  const double tone = 0.6 * (hash_unit(texture.seed, column, row) - 0.5);
  const LinearColor brick = texture.base * (1 + tone * fade(height, footprint(p)));
  return mix(brick, texture.accent, mortar);
}

LinearColor tiles(const Texture& texture, const SurfacePoint& p) {
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

LinearColor stripes(const Texture& texture, const SurfacePoint& p) {
  const double x = p.u / texture.scale;
  const double width = p.footprint_u / texture.scale;
  const double broad = filtered_pulse(x, 0.5, width);
  const double narrow = filtered_pulse(x + 0.2, 0.08, width);
  const LinearColor ground = mix(texture.base, texture.accent, 0.35 * broad + 0.65 * narrow);
  return ground * (1 + 0.5 * texture.contrast * weave(texture, texture.scale / 16, p));
}

LinearColor plaid(const Texture& texture, const SurfacePoint& p) {
  const auto bands = [&](double x, double pixel) {
    const double broad = filtered_pulse(x / texture.scale, 0.4, pixel / texture.scale);
    const double line = filtered_pulse(x / texture.scale + 0.3, 0.06, pixel / texture.scale);
    return std::min(1.0, 0.7 * broad + line);
  };
  const double share = 0.5 * (bands(p.u, p.footprint_u) + bands(p.v, p.footprint_v));
  return mix(texture.base, texture.accent, share) *
         (1 + 0.6 * texture.contrast * weave(texture, texture.scale / 8, p));
}

LinearColor carpet(const Texture& texture, const SurfacePoint& p) {
  const double to_edge =
      std::min(std::min(p.u, p.size_u - p.u), std::min(p.v, p.size_v - p.v)) / texture.scale;
  const double width = footprint(p) / texture.scale;
  const double lines = filtered_pulse(to_edge, 0.3, width);
  // Two units of border lines, then the ornament.
  const double inside = std::clamp((to_edge - 2) / width + 0.5, 0.0, 1.0);
  const double share = inside * 0.8 * lozenges(texture, p) + (1 - inside) * lines;
  return mix(texture.base, texture.accent, share) *
         (1 + 0.8 * texture.contrast * weave(texture, texture.scale / 8, p));
}

/// Returns a brightness factor about 1: irregularities at all scales from 0.3 m (plaster: three
/// times its scale) down to a 32nd of it.
double mottle(const Texture& texture, const SurfacePoint& p) {
  // Plaster has no unit except its largest blotches.
  const double largest = texture.pattern == Pattern::kPlaster ? 3 * texture.scale : 0.3;  // [m]
  const Octaves irregularities{.largest = largest, .count = 6, .persistence = 0.75};
  return 1 + texture.contrast * value_noise(texture.seed, p.u, p.v, footprint(p), irregularities);
}

SurfacePoint turned(const SurfacePoint& p) {
  return {p.v, p.u, p.size_v, p.size_u, p.footprint_v, p.footprint_u};
}

LinearColor pattern_color(const Texture& texture, const SurfacePoint& p) {
  switch (texture.pattern) {
    case Pattern::kPlaster:
      return texture.base;
    case Pattern::kWood:
      return wood(texture, p);
    case Pattern::kBricks:
      return bricks(texture, p);
    case Pattern::kTiles:
      return tiles(texture, p);
    case Pattern::kStripes:
      return stripes(texture, p);
    case Pattern::kPlaid:
      return plaid(texture, p);
    case Pattern::kCarpet:
      return carpet(texture, p);
    case Pattern::kText:
      return text(texture, p);
    case Pattern::kPoster:
      return poster(texture, p);
    case Pattern::kSpine:
      return spine(texture, p);
    case Pattern::kLandscape:
      return landscape(texture, p);
    case Pattern::kCollage:
      return collage(texture, p);
  }
  return texture.base;
}

}  // namespace

double footprint(const SurfacePoint& p) { return std::max(p.footprint_u, p.footprint_v); }

LinearColor sample(const Texture& texture, const SurfacePoint& point) {
  const SurfacePoint p = texture.quarter_turn ? turned(point) : point;
  const LinearColor color = pattern_color(texture, p) * mottle(texture, p);
  return color.max(0.0).min(1.0);
}

}  // namespace cvo_slam::synthetic
