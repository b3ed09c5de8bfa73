// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include <Eigen/Core>

namespace cvo_slam::synthetic {

/// Red, green, blue reflectance in [0, 1]; there is no gamma: twice the light, twice the grey
/// level.
using Color = Eigen::Array3d;

/// What a surface looks like. All patterns are procedural and repeat nowhere.
enum class Pattern {
  kPlaster,    ///< blotches of up to three times the scale, and grain
  kWood,       ///< planks along u with rings and grain
  kBricks,     ///< courses of bricks in mortar
  kTiles,      ///< checker of base and accent with joints
  kStripes,    ///< stripes along v (wallpaper)
  kPlaid,      ///< crossing stripes (cloth)
  kCarpet,     ///< ornament in a border
  kText,       ///< a printed page: base is the paper, accent the ink
  kPoster,     ///< picture, title and text in a white margin
  kSpine,      ///< back of a book
  kLandscape,  ///< hills under clouds: what a window shows
  kCollage,    ///< a plane full of posters, each `scale` wide
};

/// A procedural texture; a value that a scene file can describe.
struct Texture {
  Pattern pattern = Pattern::kPlaster;
  Color base = Color::Constant(0.7);
  Color accent = Color::Constant(0.4);
  double scale = 0.1;         ///< size of the pattern's unit: plank, brick, tile, line of text [m]
  double contrast = 0.3;      ///< strength of the irregularities, in [0, 1]
  bool quarter_turn = false;  ///< swaps the texture's axes, e.g. for an upright plank
  std::uint32_t seed = 0;     ///< two surfaces with different seeds look different
};

/// Where on a surface a texture is looked up, and how large the pixel is there.
struct SurfacePoint {
  double u = 0, v = 0;            ///< to the right and down from the upper left corner [m]
  double size_u = 1, size_v = 1;  ///< extent of the surface [m]
  double footprint_u = 1e-3, footprint_v = 1e-3;  ///< extent of the pixel on the surface [m]
};

/// The texture averaged over the pixel's footprint, each channel in [0, 1].
[[nodiscard]] Color sample(const Texture& texture, const SurfacePoint& point);

}  // namespace cvo_slam::synthetic
