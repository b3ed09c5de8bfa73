// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string_view>

namespace cvo_slam {

struct BuiltinCameraFile {
  std::string_view name;
  std::string_view text;
};

/// config/cameras/*.yaml as they were when the library was configured, in the order of names.
/// io/CMakeLists.txt writes the definition, so that the files and the built-in cameras are one.
std::span<const BuiltinCameraFile> builtin_camera_files();

}  // namespace cvo_slam
