// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <numbers>

#include "cvo_slam/synthetic/box_filter_internal.h"
#include "cvo_slam/synthetic/patterns_internal.h"
#include "cvo_slam/synthetic/random_internal.h"

// Patterns of cloth and paper that repeat along the axes: wallpaper, plaid, carpet.

namespace cvo_slam::synthetic {
namespace {

/// Crossed threads of `thread` [m], in [-1, 1].
double weave(const Texture& texture, double thread, const SurfacePoint& p) {
  const double tone = filtered_cells(
      p.u / thread, p.v / thread, p.footprint_u / thread, p.footprint_v / thread,
      [&](std::int32_t i, std::int32_t j) { return 2 * hash_unit(texture.seed, i, j) - 1; });
  return tone * fade(thread, 0.7 * footprint(p));
}

/// A lozenge lattice with the pattern's unit as period: 1 inside the lozenges, 0 outside.
double lozenges(const Texture& texture, const SurfacePoint& p) {
  const double u = p.u / texture.scale;
  const double v = p.v / texture.scale;
  const double width = footprint(p) / texture.scale * std::numbers::sqrt2;
  const double rising = filtered_pulse(u + v, 0.5, width);
  const double falling = filtered_pulse(u - v, 0.5, width);
  return rising + falling - 2 * rising * falling;
}

}  // namespace

Color stripes(const Texture& texture, const SurfacePoint& p) {
  const double x = p.u / texture.scale;
  const double width = p.footprint_u / texture.scale;
  const double broad = filtered_pulse(x, 0.5, width);
  const double narrow = filtered_pulse(x + 0.2, 0.08, width);
  const Color ground = mix(texture.base, texture.accent, 0.35 * broad + 0.65 * narrow);
  return ground * (1 + 0.5 * texture.contrast * weave(texture, texture.scale / 16, p));
}

Color plaid(const Texture& texture, const SurfacePoint& p) {
  const auto bands = [&](double x, double pixel) {
    const double broad = filtered_pulse(x / texture.scale, 0.4, pixel / texture.scale);
    const double line = filtered_pulse(x / texture.scale + 0.3, 0.06, pixel / texture.scale);
    return std::min(1.0, 0.7 * broad + line);
  };
  const double share = 0.5 * (bands(p.u, p.footprint_u) + bands(p.v, p.footprint_v));
  return mix(texture.base, texture.accent, share) *
         (1 + 0.6 * texture.contrast * weave(texture, texture.scale / 8, p));
}

Color carpet(const Texture& texture, const SurfacePoint& p) {
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

}  // namespace cvo_slam::synthetic
