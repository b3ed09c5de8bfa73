// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "cvo_slam/io/synthetic/camera_path.h"
#include "cvo_slam/io/synthetic/scene.h"

namespace cvo_slam::synthetic {

/// A furnished room of 5.2 x 4.4 x 2.6 m with its floor's centre at the origin.
[[nodiscard]] Scene room_scene(std::uint32_t seed);

/// A round of 10 s and 4 m near the room's centre that looks outwards, once along all the walls.
[[nodiscard]] CameraPath room_path(std::uint32_t seed);

}  // namespace cvo_slam::synthetic
