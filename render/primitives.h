// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace cvo_slam::render {

/// A piece of surface on the image: an ellipse, the picture of a disc. Pixels (x, y) with
/// dx^2 + dy^2 + (slope_x dx + slope_y dy)^2 <= radius^2 are in it, dx and dy from its centre.
struct Splat {
  float x = 0;  ///< of its centre [px]; (0, 0) is the centre of the upper left pixel
  float y = 0;
  float depth = 0;   ///< 0 = nearest to 1 = furthest
  float radius = 0;  ///< [px], at most kMaxSplatRadius
  float slope_x = 0;
  float slope_y = 0;
  std::array<std::uint8_t, 4> color = {0, 0, 0, 255};  ///< blue, green, red; the fourth is unused
};

/// Points of OpenGL have a largest size, 255 pixels in Mesa.
inline constexpr float kMaxSplatRadius = 120;

/// A corner of a triangle on the image.
struct Corner {
  float x = 0;  ///< [px]
  float y = 0;
  float depth = 0;                                     ///< 0 = nearest to 1 = furthest
  std::array<std::uint8_t, 4> color = {0, 0, 0, 255};  ///< blue, green, red; the fourth is unused
};

/// All that a renderer is asked to draw; the nearest is seen.
struct Primitives {
  std::vector<Splat> splats;
  std::vector<Corner> corners;  ///< three in a row are a triangle, of either orientation
};

}  // namespace cvo_slam::render
