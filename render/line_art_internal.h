// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// All that is drawn with lines and dots, and its colours: paths, keyframes, constraints, axes.
#pragma once

#include <array>
#include <cstdint>

#include "cvo_slam/render/extent_internal.h"
#include "cvo_slam/render/map_scene.h"
#include "cvo_slam/render/map_view.h"
#include "cvo_slam/render/renderer.h"

namespace cvo_slam::render {

/// Colours for the values of paths: from dark blue over red to yellow, with increasing lightness,
/// so that colour-blind readers and grey prints can tell them apart.
class ColorScale {
 public:
  /// The scale spans the values of all paths; it starts at zero if no value is negative.
  explicit ColorScale(const MapScene& scene);

  [[nodiscard]] bool empty() const { return !(max_ > min_); }
  [[nodiscard]] double min() const { return min_; }
  [[nodiscard]] double max() const { return max_; }
  /// Returns the colour of a value; grey if it is not finite.
  [[nodiscard]] Color operator()(double value) const;

 private:
  std::array<Color, 256> table_;
  double min_ = 0;
  double max_ = 0;
};

inline constexpr Color kKeyframeColor = kOrange;
inline constexpr std::array<Color, 3> kAxisColors = {kVermilion, kGreen, kBlue};  ///< x, y, z
[[nodiscard]] Color color_of(EdgeKind kind);

/// Adds lines and dots, whose width is in pixels, to the primitives of a picture.
class LineArt {
 public:
  /// Both must outlive the object.
  LineArt(const MapView& view, Primitives& primitives) : view_(view), primitives_(primitives) {}

  /// Adds a line from a to b in the world, `width` [px] wide. Its colour changes from that of a to
  /// that of b.
  void line(const Vector3& a, const Vector3& b, double width, Color color_a, Color color_b);
  void line(const Vector3& a, const Vector3& b, double width, Color color) {
    line(a, b, width, color, color);
  }
  void dot(const Vector3& place, double radius, Color color);

 private:
  const MapView& view_;
  Primitives& primitives_;
};

// In the functions below, `unit` is the width of a thin line [px].

/// Draws the paths as ribbons.
void add_paths(const MapScene& scene, const ColorScale& scale, double unit, LineArt& art);

/// Draws a frustum for each keyframe, unless one that is drawn already has nearly the same pose.
void add_keyframes(const MapScene& scene, const Extent& extent, double unit, LineArt& art);

void add_constraints(const MapScene& scene, double unit, LineArt& art);

/// Draws the axes of the world at its origin, if shows_axes().
void add_axes(const Extent& extent, double unit, LineArt& art);
/// Returns true if the origin of the world is in or near the scene.
[[nodiscard]] bool shows_axes(const Extent& extent);
[[nodiscard]] double axis_length(const Extent& extent);

}  // namespace cvo_slam::render
