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

/// Returns the files config/cameras/*.yaml as they were when the library was configured, in the
/// order of their names. CMake writes the definition (io/CMakeLists.txt), so that there is one text
/// of each camera.
std::span<const BuiltinCameraFile> builtin_camera_files();

}  // namespace cvo_slam
