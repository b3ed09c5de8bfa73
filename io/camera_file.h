// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cvo_slam/core/camera.h"

namespace cvo_slam {

/// Reads a camera from YAML: our own keys (config/cameras/*.yaml) or those of ORB-SLAM2/3, which
/// are told apart by a key "Camera.fx" or "Camera1.fx".
/// Throws InputError (file, line, key).
[[nodiscard]] Camera read_camera(const std::filesystem::path& file);

/// Writes a camera with our own keys; read_camera() gives back the same numbers, except that the
/// rotation of a depth camera is rounded to the nearest proper one. Throws OutputError.
void write_camera(const std::filesystem::path& file, const Camera& camera);

/// The built-in camera of that name; throws OptionError that lists the names.
[[nodiscard]] Camera builtin_camera(const std::string& name);
[[nodiscard]] std::vector<std::string> builtin_camera_names();

/// What a user may write after --camera: the name of a built-in camera, or a file.
/// Throws InputError.
[[nodiscard]] Camera find_camera(const std::string& name_or_file);

}  // namespace cvo_slam
