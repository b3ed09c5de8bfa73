// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>

#include "cvo_slam/synthetic/sensor_options.h"
#include "cvo_slam/synthetic/world_scene.h"

namespace cvo_slam::synthetic {

/// Adds boxes that swing through the field of view in [0, duration] s and keep clear of the
/// camera's path. Throws OptionError if there is no space for one.
void add_moving_objects(WorldScene& scene, const std::function<SE3(double seconds)>& T_world_camera,
                        double duration, const MovingObjectOptions& options, std::uint32_t seed);

}  // namespace cvo_slam::synthetic
