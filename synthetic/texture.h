// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include <Eigen/Core>

namespace cvo_slam::synthetic {

/// Red, green and blue on a linear scale, 1 = white. There is no gamma: twice the light gives twice
/// the grey level.
using LinearColor = Eigen::Array3d;

/// The pattern of a surface. All patterns are procedural and do not repeat.
enum class Pattern {
  kPlaster,    ///< blotches of up to three times the scale, and grain
  kWood,       ///< planks along u with rings and grain
  kBricks,     ///< courses of bricks in mortar
  kTiles,      ///< chequers of base and accent with joints
  kStripes,    ///< stripes along v, as on wallpaper
  kPlaid,      ///< crossing stripes, as on cloth
  kCarpet,     ///< ornament in a border
  kText,       ///< printed page: base is the paper, accent the ink
  kPoster,     ///< picture, title and text in a white margin
  kSpine,      ///< back of a book
  kLandscape,  ///< hills under clouds, as seen through a window
  kCollage,    ///< plane full of posters, each `scale` wide
};

/// A procedural texture; world files can describe all of it.
struct Texture {
  Pattern pattern = Pattern::kPlaster;              ///< what is drawn with the two colours
  LinearColor base = LinearColor::Constant(0.7);    ///< reflectance in [0, 1]
  LinearColor accent = LinearColor::Constant(0.4);  ///< reflectance in [0, 1]
  double scale = 0.1;         ///< size of the pattern's unit: plank, brick, tile, line of text [m]
  double contrast = 0.3;      ///< strength of the irregularities, in [0, 1]
  bool quarter_turn = false;  ///< swaps the axes of the texture, as an upright plank needs
  std::uint32_t seed = 0;     ///< two surfaces with different seeds look different
};

/// A position on a surface, and the size of a pixel there.
struct SurfacePoint {
  ///@{
  /// Distance to the right (u) or down (v) from the upper left corner [m].
  double u = 0, v = 0;
  ///@}
  ///@{
  /// Extent of the surface along u or v [m].
  double size_u = 1, size_v = 1;
  ///@}
  ///@{
  /// Extent of the pixel on the surface along u or v [m].
  double footprint_u = 1e-3, footprint_v = 1e-3;
  ///@}
};

/// Returns the reflectance averaged over the footprint of the pixel, each channel in [0, 1].
[[nodiscard]] LinearColor sample(const Texture& texture, const SurfacePoint& point);

}  // namespace cvo_slam::synthetic
