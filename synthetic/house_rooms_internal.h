// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cvo_slam/synthetic/scene_builder_internal.h"

// The house's measures, and what stands in it. The x axis points east, y north; all in metres.

namespace cvo_slam::synthetic::house {

inline constexpr double kCeiling = 2.5;
inline constexpr double kEnd = 10.75;      ///< the outer walls in the west and east
inline constexpr double kHalf = 6.75;      ///< ends of the corridors, where the large rooms begin
inline constexpr double kOuter = 4.0;      ///< the outer walls in the south and north
inline constexpr double kInner = 2.4;      ///< the corridors' inner walls
inline constexpr double kAisle = 3.2;      ///< the corridors' middle lines
inline constexpr double kOpenDoor = -1.7;  ///< along each corridor, as seen from it

/// The northern corridor (side = 1), or the southern one (-1), which is the same turned by half a
/// turn but for the grain of its materials.
void furnish_corridor(SceneBuilder& builder, double side);
void furnish_living_room(SceneBuilder& builder);
void furnish_kitchen(SceneBuilder& builder);
void furnish_study(SceneBuilder& builder);
void furnish_bedroom(SceneBuilder& builder);

}  // namespace cvo_slam::synthetic::house
