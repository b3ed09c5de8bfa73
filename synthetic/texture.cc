// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/synthetic/texture.h"

#include <algorithm>
#include <utility>

#include "cvo_slam/synthetic/patterns_internal.h"
#include "cvo_slam/synthetic/value_noise_internal.h"

namespace cvo_slam::synthetic {
namespace {

SurfacePoint turned(const SurfacePoint& p) {
  return {p.v, p.u, p.size_v, p.size_u, p.footprint_v, p.footprint_u};
}

Color pattern_color(const Texture& texture, const SurfacePoint& p) {
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

double mottle(const Texture& texture, const SurfacePoint& p) {
  // Plaster has no unit but its largest blotches, which are three times its scale.
  const double largest = texture.pattern == Pattern::kPlaster ? 3 * texture.scale : 0.3;  // [m]
  const Octaves irregularities{.largest = largest, .count = 6, .persistence = 0.75};
  return 1 + texture.contrast * value_noise(texture.seed, p.u, p.v, footprint(p), irregularities);
}

Color sample(const Texture& texture, const SurfacePoint& point) {
  const SurfacePoint p = texture.quarter_turn ? turned(point) : point;
  const Color color = pattern_color(texture, p) * mottle(texture, p);
  return color.max(0.0).min(1.0);
}

}  // namespace cvo_slam::synthetic
