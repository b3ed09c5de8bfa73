// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cvo_slam/core/camera.h"

namespace cvo_slam {

/// Reads a camera from YAML: our own keys (config/cameras/*.yaml) or those of ORB-SLAM2/3.
/// Throws InputError (file, line, key).
[[nodiscard]] Camera read_camera(const std::filesystem::path& file);

/// The built-in camera of that name; throws OptionError that lists the names.
[[nodiscard]] Camera builtin_camera(const std::string& name);
[[nodiscard]] std::vector<std::string> builtin_camera_names();

}  // namespace cvo_slam
