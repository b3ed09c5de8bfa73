// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>

#include "cvo_slam/synthetic/scene.h"
#include "cvo_slam/synthetic/sensor_options.h"

namespace cvo_slam::synthetic {

/// Adds boxes that swing through what the camera sees in [0, duration] s, clear of the camera's
/// way. Throws OptionError where there is no place for one.
void add_moving_objects(Scene& scene, const std::function<SE3(double seconds)>& T_world_camera,
                        double duration, const MovingObjectOptions& options, std::uint32_t seed);

}  // namespace cvo_slam::synthetic
