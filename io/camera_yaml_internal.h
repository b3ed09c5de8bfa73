// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include <yaml-cpp/yaml.h>

#include "cvo_slam/core/camera.h"

namespace cvo_slam {

/// A camera from the text of `file`, which is named in errors only. Throws InputError.
Camera parse_camera(const std::string& text, const std::filesystem::path& file);

/// With the keys of ORB-SLAM2 (Camera.fx, Camera.k1, DepthMapFactor) or ORB-SLAM3 (Camera1.fx,
/// Camera1.k1, RGBD.DepthMapFactor); all other keys of such a file are ignored.
bool has_orb_slam_keys(const YAML::Node& root);
Camera parse_orb_slam_camera(const YAML::Node& root, const std::filesystem::path& path);

/// With our own keys.
std::string camera_to_yaml(const Camera& camera);

/// A finite number; throws InputError with the line.
double parse_yaml_number(const YAML::Node& node, const std::string& key,
                         const std::filesystem::path& file);
/// A positive number of pixels.
int parse_yaml_size(const YAML::Node& node, const std::string& key,
                    const std::filesystem::path& file);

}  // namespace cvo_slam
