// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/io/dataset.h"

namespace cvo_slam {

/// The built-in camera that the name of a sequence calls for ("rgbd_dataset_freiburg1_rpy",
/// "fr1_rpy", "living_room_traj2_frei_png"); empty where it calls for none.
std::optional<std::string> camera_named_by(const std::string& sequence_name);

/// The camera that the options or a camera.yaml in the folder give, else the built-in one.
/// Throws InputError where `builtin` is empty too.
Camera choose_camera(const std::filesystem::path& folder, const DatasetOptions& options,
                     const std::optional<std::string>& builtin);

}  // namespace cvo_slam
