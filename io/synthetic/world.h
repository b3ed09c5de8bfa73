// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cvo_slam/io/synthetic/camera_path.h"
#include "cvo_slam/io/synthetic/scene.h"

namespace cvo_slam::synthetic {

/// A scene and a camera's way through it.
struct World {
  Scene scene;
  CameraPath path;
};

/// The built-in world of that name. The seed changes textures, clutter and tremor, not the plan.
/// Throws OptionError for an unknown name; the message gives the nearest one.
[[nodiscard]] World make_world(const std::string& name, std::uint32_t seed);
[[nodiscard]] std::vector<std::string> world_names();

}  // namespace cvo_slam::synthetic
