// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <regex>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/io/camera_file.h"
#include "cvo_slam/io/dataset_camera_internal.h"
#include "cvo_slam/io/text_internal.h"

namespace cvo_slam {

std::optional<std::string> camera_named_by(const std::string& sequence_name) {
  const std::string name = to_lower(sequence_name);
  std::smatch match;
  static const std::regex kTum("(?:^|[^a-z])(?:freiburg|fr)([123])(?:[^0-9]|$)");
  if (std::regex_search(name, match, kTum)) return "tum_fr" + match[1].str();
  static const std::regex kIclNuim(
      "(?:^|[^a-z])icl(?:[^a-z]|$)|living_?room|office_(?:room_)?(?:kt|traj)|traj[0-3]_frei");
  if (std::regex_search(name, kIclNuim)) return "icl_nuim";
  return std::nullopt;
}

Camera choose_camera(const std::filesystem::path& folder, const DatasetOptions& options,
                     const std::optional<std::string>& builtin) {
  if (options.camera) {
    options.camera->check();
    return *options.camera;
  }
  const std::filesystem::path file = folder / "camera.yaml";
  if (std::filesystem::exists(file)) return read_camera(file);
  if (builtin) return builtin_camera(*builtin);
  throw InputError(folder, fmt::format("no camera is known for this sequence; give --camera (a "
                                       "YAML file, or one of {}) or put a camera.yaml into it",
                                       fmt::join(builtin_camera_names(), ", ")));
}

}  // namespace cvo_slam
