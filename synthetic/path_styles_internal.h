// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cvo_slam/synthetic/world.h"

namespace cvo_slam::synthetic {

/// A path of that style through the world, of a duration that suits it. Throws OptionError where
/// the world leaves no room for it.
[[nodiscard]] CameraPath path_of(PathStyle style, const World& world, std::uint32_t seed);

/// Viewpoints at equal distances along the corners' connection, each looking at the point `ahead`
/// [m] further along, `drop` [m] below its own height. Of an open way the last ones look straight
/// on.
[[nodiscard]] std::vector<Viewpoint> walk_along(const std::vector<Vector3>& corners, bool closed,
                                                double spacing, double ahead, double drop);

}  // namespace cvo_slam::synthetic
