// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "cvo_slam/synthetic/box_filter_internal.h"
#include "cvo_slam/synthetic/patterns_internal.h"
#include "cvo_slam/synthetic/random_internal.h"
#include "cvo_slam/synthetic/value_noise_internal.h"

// Printed matter: text, posters, backs of books, and the landscape in a window.

namespace cvo_slam::synthetic {
namespace {

// A letter is a random 3 x 5 bitmap in a cell of 4 x 7 dots. One in six is a gap between words.
constexpr int kLetterColumns = 4;
constexpr int kLineRows = 7;
constexpr double kGapShare = 1.0 / 6.0;
constexpr double kDotShare = 0.6;
constexpr int kLetterRows = 5;
constexpr double kLineShare = static_cast<double>(kLetterRows) / kLineRows;
constexpr double kLetterInk =
    kDotShare * (kLetterColumns - 1) / kLetterColumns;  // mean ink in its rows

std::int32_t floor_div(std::int32_t a, std::int32_t b) {
  return a >= 0 ? a / b : -((b - 1 - a) / b);
}

bool is_gap(std::uint32_t seed, std::int32_t letter, std::int32_t line) {
  return hash_unit(seed, letter, line) < kGapShare;
}

double dot(std::uint32_t seed, std::int32_t column, std::int32_t row) {
  const std::int32_t letter = floor_div(column, kLetterColumns);
  const std::int32_t line = floor_div(row, kLineRows);
  const bool spacing = column - letter * kLetterColumns == kLetterColumns - 1 ||
                       row - line * kLineRows >= kLetterRows;
  if (spacing || is_gap(seed, letter, line)) return 0;
  return hash_unit(seed + 1, column, row) < kDotShare ? 1 : 0;
}

/// Returns the ink for pixels that do not resolve single dots, but perhaps words and lines.
double unresolved_ink(std::uint32_t seed, double line, const SurfacePoint& p) {
  const double letter = line * kLetterColumns / kLineRows;
  const double printed = filtered_cells(
      p.u / letter, p.v / line, p.footprint_u / letter, p.footprint_v / line,
      [seed](std::int32_t i, std::int32_t j) { return is_gap(seed, i, j) ? 0.0 : 1.0; });
  const double words =
      (1 - kGapShare) + (printed - (1 - kGapShare)) * fade(letter, 0.5 * footprint(p));
  return kLetterInk * words * filtered_pulse(p.v / line, kLineShare, p.footprint_v / line);
}

/// Returns the part of a surface between the shares (left, top) and (right, bottom) of its size.
SurfacePoint part(const SurfacePoint& p, double left, double top, double right, double bottom) {
  SurfacePoint inner = p;
  inner.u -= left * p.size_u;
  inner.v -= top * p.size_v;
  inner.size_u *= right - left;
  inner.size_v *= bottom - top;
  return inner;
}

/// Returns the share of the pixel on the surface: 1 inside, 0 outside, linear across the rim.
double inside(const SurfacePoint& p) {
  const auto covered = [](double x, double size, double pixel) {
    const double depth = std::min(x, size - x);
    if (std::abs(depth) >= pixel) return depth > 0 ? 1.0 : 0.0;  // most pixels: saves the division
    return std::clamp(depth / pixel + 0.5, 0.0, 1.0);
  };
  const double along_u = covered(p.u, p.size_u, p.footprint_u);
  return along_u == 0 ? 0 : along_u * covered(p.v, p.size_v, p.footprint_v);
}

LinearColor vivid(std::uint32_t seed, std::int32_t index) {
  return {0.1 + 0.85 * hash_unit(seed, index, 1), 0.1 + 0.85 * hash_unit(seed, index, 2),
          0.1 + 0.85 * hash_unit(seed, index, 3)};
}

/// Draws discs of random colours over a colour.
LinearColor with_discs(LinearColor color, std::uint32_t seed, const SurfacePoint& p) {
  constexpr int kDiscs = 9;
  constexpr double kLeast = 0.04;
  constexpr double kMost = 0.18;  // least and largest radius, as a share of the shorter side
  const double side = std::min(p.size_u, p.size_v);
  const double reach = kMost * side + footprint(p);
  for (int k = 0; k < kDiscs; ++k) {
    const double u = p.u - p.size_u * hash_unit(seed, k, 4);
    if (std::abs(u) > reach) continue;  // most discs: saves further random numbers
    const double v = p.v - p.size_v * hash_unit(seed, k, 5);
    if (std::abs(v) > reach) continue;
    const double radius = side * (kLeast + (kMost - kLeast) * hash_unit(seed, k, 6));
    const double ring = std::abs(std::sqrt(u * u + v * v) - 0.7 * radius);
    const double covered = std::clamp((0.3 * radius - ring) / footprint(p) + 0.5, 0.0, 1.0);
    if (covered > 0) color = mix(color, vivid(seed + 9, k), covered);
  }
  return color;
}

/// Returns the colour of an artwork: coloured bands that follow a random relief, and discs.
LinearColor artwork(std::uint32_t seed, const SurfacePoint& p) {
  constexpr int kBands = 7;
  const Octaves relief{.largest = 0.45 * p.size_u, .count = 5, .persistence = 0.45};
  const double height = value_noise(seed, p.u, p.v, footprint(p), relief);
  const double level = kBands * (0.5 + 0.9 * height);
  const double band = std::floor(level);
  // The seam between bands is roughly as wide as a pixel on the slope of the relief.
  const double softness = std::min(1.0, 0.02 + 2 * kBands * footprint(p) / p.size_u);
  const double seam = std::clamp((level - band - 1 + softness) / softness, 0.0, 1.0);
  const auto index = static_cast<std::int32_t>(band);
  return with_discs(mix(vivid(seed, index), vivid(seed, index + 1), seam), seed, p);
}

/// Returns the share of ink in [0, 1] on a page of text-like strokes with lines `line` [m] apart.
double ink(std::uint32_t seed, double line, const SurfacePoint& p) {
  const double size = line / kLineRows;
  const double resolved = fade(size, 0.5 * footprint(p));
  // Dots that cannot be resolved become the grey of their letters; letters become that of their
  // line.
  const double blurred = resolved < 1 ? unresolved_ink(seed, line, p) : 0;
  if (resolved == 0) return blurred;
  const double sharp = filtered_cells(
      p.u / size, p.v / size, p.footprint_u / size, p.footprint_v / size,
      [seed](std::int32_t column, std::int32_t row) { return dot(seed, column, row); });
  return blurred + (sharp - blurred) * resolved;
}

}  // namespace

LinearColor text(const Texture& texture, const SurfacePoint& p) {
  const SurfacePoint page = part(p, 0.07, 0.06, 0.93, 0.94);
  const double strokes = ink(texture.seed, texture.scale, page) * inside(page);
  return mix(texture.base, texture.accent, strokes);
}

LinearColor poster(const Texture& texture, const SurfacePoint& p) {
  const SurfacePoint image = part(p, 0.06, 0.05, 0.94, 0.70);
  const SurfacePoint title = part(p, 0.08, 0.74, 0.92, 0.84);
  const SurfacePoint lines = part(p, 0.08, 0.87, 0.92, 0.96);
  LinearColor color = texture.base;
  if (const double share = inside(image); share > 0) {
    color = mix(color, artwork(texture.seed, image), share);
  }
  if (const double share = inside(title); share > 0) {
    color = mix(color, texture.accent, share * ink(texture.seed, title.size_v, title));
  }
  if (const double share = inside(lines); share > 0) {
    color = mix(color, texture.accent, share * ink(texture.seed, lines.size_v / 3, lines));
  }
  return color;
}

namespace {

/// Returns one sample of a plane of posters, as accurate as poster().
LinearColor collage_sample(const Texture& texture, const SurfacePoint& p) {
  constexpr double kGap = 0.06;  // between posters, as a share of their width
  const double width = (1 + kGap) * texture.scale;
  const double height = (std::numbers::sqrt2 + kGap) * texture.scale;
  const double column = std::floor(p.u / width);
  const auto i = static_cast<std::int32_t>(column);
  const double v = p.v + height * hash_unit(texture.seed, i);  // columns hang at different heights
  const double row = std::floor(v / height);
  SurfacePoint sheet = p;
  sheet.u -= width * column + 0.5 * kGap * texture.scale;
  sheet.v = v - height * row - 0.5 * kGap * texture.scale;
  sheet.size_u = texture.scale;
  sheet.size_v = std::numbers::sqrt2 * texture.scale;
  LinearColor wall = LinearColor::Constant(0.45);
  const double share = inside(sheet);
  if (share == 0) return wall;
  Texture print = texture;
  print.seed = hash(texture.seed + 1, i, static_cast<std::int32_t>(row));
  return mix(wall, poster(print, sheet), share);
}

}  // namespace

LinearColor collage(const Texture& texture, const SurfacePoint& p) {
  // Pixels are larger on these posters than on one that fills its wall. Hence two samples a pixel
  // on its diagonal or, if pixels are very large, two more on the other diagonal.
  const bool is_far = footprint(p) > 0.03 * texture.scale;
  SurfacePoint half = p;
  half.footprint_u = 0.5 * p.footprint_u;
  half.footprint_v = 0.5 * p.footprint_v;
  const auto sample_at = [&](double across, double along) -> LinearColor {
    half.u = p.u + across * p.footprint_u;
    half.v = p.v + along * p.footprint_v;
    return collage_sample(texture, half);
  };
  LinearColor diagonal = 0.5 * (sample_at(-0.25, -0.25) + sample_at(0.25, 0.25));
  if (!is_far) return diagonal;
  return 0.5 * diagonal + 0.25 * (sample_at(-0.25, 0.25) + sample_at(0.25, -0.25));
}

LinearColor spine(const Texture& texture, const SurfacePoint& p) {
  const SurfacePoint label = part(p, 0.15, 0.2, 0.85, 0.8);
  const double bands = filtered_pulse(8 * p.v / p.size_v - 0.6, 0.25, 8 * p.footprint_v / p.size_v);
  const bool banded = hash_unit(texture.seed, 1) < 0.5;
  LinearColor color = mix(texture.base, texture.accent, banded ? 0.7 * bands : 0.0);
  // The title runs down the back.
  const SurfacePoint along{label.v,      label.u,       label.size_v,
                           label.size_u, p.footprint_v, p.footprint_u};
  const double title = inside(label) * ink(texture.seed, label.size_u, along);
  return mix(color, texture.accent, title);
}

LinearColor landscape(const Texture& texture, const SurfacePoint& p) {
  constexpr Octaves kClouds{.largest = 0.5, .count = 6, .persistence = 0.55};
  const double height = p.v / p.size_v;
  const double cloud = value_noise(texture.seed, 0.5 * p.u, p.v, footprint(p), kClouds);
  const LinearColor sky = mix(texture.base, LinearColor::Constant(0.95),
                              std::clamp(0.2 + 0.5 * height + 1.2 * cloud, 0.0, 1.0));
  LinearColor color = sky;
  constexpr std::array<double, 3> kHorizons = {0.55, 0.66, 0.78};
  for (std::size_t k = 0; k < kHorizons.size(); ++k) {
    const auto seed = texture.seed + 10 + static_cast<std::uint32_t>(k);
    const double ridge =
        kHorizons[k] * p.size_v + 0.15 * value_noise(seed, p.u, 0, footprint(p), kClouds);
    const double covered = std::clamp((p.v - ridge) / p.footprint_v + 0.5, 0.0, 1.0);
    if (covered == 0) continue;
    const double leaves = value_noise(seed, p.u, p.v, footprint(p), {0.08, 5, 0.8});
    const LinearColor hill =
        texture.accent * (1.3 - 0.3 * static_cast<double>(k)) * (1 + 0.8 * leaves);
    color = mix(color, hill, covered);
  }
  return color;
}

}  // namespace cvo_slam::synthetic
