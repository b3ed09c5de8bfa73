// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "cvo_slam/synthetic/world.h"

namespace cvo_slam::synthetic {

/// Returns a path of that style through the world, of a duration that suits it. Throws OptionError
/// if the world leaves no space for it.
[[nodiscard]] CameraPath path_of(PathStyle style, const World& world, std::uint32_t seed);

/// Returns viewpoints `spacing` [m] apart along the line through the corners. Each looks at the
/// point `ahead` [m] further along, `drop` [m] below its own height. The last ones of an open line
/// look straight on.
[[nodiscard]] std::vector<Viewpoint> walk_along(const std::vector<Vector3>& corners, bool closed,
                                                double spacing, double ahead, double drop);

/// Least distance that the camera must keep from surfaces [m].
inline constexpr double kNearestSurface = 0.05;

struct Collision {
  double seconds = 0;
  std::size_t primitive = 0;
};

/// Returns the first time at which the camera is too near to a surface; empty if it never is.
[[nodiscard]] std::optional<Collision> first_collision(const WorldScene& scene,
                                                       const CameraPath& path);

}  // namespace cvo_slam::synthetic
