// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "cvo_slam/synthetic/world.h"

namespace cvo_slam::synthetic {

// The built-in worlds. A seed changes textures, clutter and tremor, but not the layout.

/// A furnished room of 5.2 x 4.4 x 2.6 m with the centre of its floor at the origin. The path is a
/// closed one of 10 s and 4 m near the centre; the camera looks outwards, once along all the walls.
[[nodiscard]] World room_world(std::uint32_t seed);

/// An office of 7 x 5.6 x 2.7 m with four desks face to face in its middle and more along its
/// walls. The path is a closed one of 24 s about the desks in the middle.
[[nodiscard]] World office_world(std::uint32_t seed);

/// A house of 20 x 9.2 m: two ambiguous corridors between a living room and a kitchen, and two
/// rooms between the corridors. The path leads through all of it and beyond its start.
[[nodiscard]] World house_world(std::uint32_t seed);

/// The properties that the fr3 series of the TUM RGB-D benchmark names.
struct PanelOptions {
  bool structure = true;  ///< zig-zag of panels on a floor; otherwise only the floor
  bool texture = true;    ///< posters; otherwise paint with a contrast of two grey levels
  bool near = true;       ///< seen from about 1 m; otherwise from about 2 m
};
[[nodiscard]] World panel_world(const PanelOptions& options, std::uint32_t seed);

}  // namespace cvo_slam::synthetic
