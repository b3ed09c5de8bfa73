// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/io/camera_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/io/builtin_camera_files_internal.h"
#include "cvo_slam/io/camera_yaml_internal.h"

namespace cvo_slam {

Camera read_camera(const std::filesystem::path& file) {
  return parse_camera(read_file(file), file);
}

void write_camera(const std::filesystem::path& file, const Camera& camera) {
  write_file(file, camera_to_yaml(camera));
}

Camera builtin_camera(const std::string& name) {
  for (const auto& file : builtin_camera_files()) {
    if (file.name == name) return parse_camera(std::string(file.text), name + ".yaml");
  }
  throw OptionError(fmt::format("no built-in camera '{}'; there are {}", name,
                                fmt::join(builtin_camera_names(), ", ")));
}

std::vector<std::string> builtin_camera_names() {
  std::vector<std::string> names;
  for (const auto& file : builtin_camera_files()) names.emplace_back(file.name);
  return names;
}

Camera find_camera(const std::string& name_or_file) {
  for (const auto& file : builtin_camera_files()) {
    if (file.name == name_or_file) return builtin_camera(name_or_file);
  }
  if (!std::filesystem::exists(name_or_file)) {
    throw InputError(name_or_file, fmt::format("no such camera file; the built-in cameras are {}",
                                               fmt::join(builtin_camera_names(), ", ")));
  }
  return read_camera(name_or_file);
}

}  // namespace cvo_slam
