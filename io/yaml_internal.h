// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include <yaml-cpp/yaml.h>

namespace cvo_slam {

/// Parses YAML text. The directive "%YAML:1.0" of OpenCV's files, which is not YAML, is skipped.
/// Throws InputError with `file` and line unless the text is a map with distinct scalar keys
/// (or empty).
YAML::Node parse_yaml(std::string text, const std::filesystem::path& file);
YAML::Node load_yaml(const std::filesystem::path& file);

/// The line of a node, from 1; 0 where it is not known.
long line_of(const YAML::Node& node);

}  // namespace cvo_slam
