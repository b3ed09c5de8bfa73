// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cvo_slam/render/color_scale_internal.h"
#include "cvo_slam/render/extent_internal.h"
#include "cvo_slam/render/line_art_internal.h"

namespace cvo_slam::render {

inline constexpr Color kKeyframeColor = kOrange;
[[nodiscard]] Color color_of(EdgeKind kind);

/// The paths as ribbons. `unit` is the width of a thin line [px], here and below.
void add_paths(const Scene& scene, const ColorScale& scale, double unit, LineArt& art);

/// A frustum each, but none over another that looks the same way.
void add_keyframes(const Scene& scene, const Extent& extent, double unit, LineArt& art);

void add_constraints(const Scene& scene, double unit, LineArt& art);

/// The axes of the world at its origin: x, y and z in vermilion, green and blue.
void add_axes(const Extent& extent, double unit, LineArt& art);

/// Whether the world's origin is in or near the scene, and its axes are drawn.
[[nodiscard]] bool shows_axes(const Extent& extent);
[[nodiscard]] double axis_length(const Extent& extent);
inline constexpr std::array<Color, 3> kAxisColors = {kVermilion, kGreen, kBlue};

}  // namespace cvo_slam::render
