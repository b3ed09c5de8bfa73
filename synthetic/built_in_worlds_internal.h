// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "cvo_slam/synthetic/world.h"

namespace cvo_slam::synthetic {

// The built-in worlds. A seed changes textures, clutter and tremor, not the plan.

/// A furnished room of 5.2 x 4.4 x 2.6 m with its floor's centre at the origin; a round of 10 s and
/// 4 m near its centre that looks outwards, once along all the walls.
[[nodiscard]] World room_world(std::uint32_t seed);

/// An office of 7 x 5.6 x 2.7 m with four desks face to face in its middle and more along its
/// walls; a round of 24 s about the middle ones.
[[nodiscard]] World office_world(std::uint32_t seed);

/// A house of 20 x 9.2 m: two look-alike corridors between a living room and a kitchen, with two
/// rooms to look into between them; a walk through all of it and beyond its start.
[[nodiscard]] World house_world(std::uint32_t seed);

/// What the names of the fr3 series of TUM's benchmark say.
struct PanelOptions {
  bool structure = true;  ///< a zig-zag of panels on a floor; else nothing but the floor
  bool texture = true;    ///< posters; else paint with a residual contrast of two grey levels
  bool near = true;       ///< from about 1 m; else from about 2 m
};
[[nodiscard]] World panel_world(const PanelOptions& options, std::uint32_t seed);

}  // namespace cvo_slam::synthetic
