// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <system_error>

#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/synthetic/output_folder_internal.h"

namespace cvo_slam::synthetic {
namespace fs = std::filesystem;
namespace {

void require_writable_place(const fs::path& folder) {
  if (!fs::exists(folder) || fs::exists(folder / kMarkerFile)) return;
  if (!fs::is_directory(folder)) {
    throw OutputError(folder, "is not a folder; give another output folder");
  }
  if (!fs::is_empty(folder)) {
    throw OutputError(folder, fmt::format("is not empty and not a synthetic sequence (no {}); give "
                                          "another output folder",
                                          kMarkerFile));
  }
}

/// Removes what write_sequence() made; what else lies in the folder stays.
void remove_old_sequence(const fs::path& folder) {
  // Lists first: what is left after an interruption is then no sequence any more.
  for (const char* name : {"rgb.txt", "depth.txt", "groundtruth.txt", "camera.yaml"}) {
    fs::remove(folder / name);
  }
  for (const char* name : {"rgb", "depth"}) fs::remove_all(folder / name);
}

}  // namespace

void prepare_output_folder(const fs::path& folder) {
  try {
    require_writable_place(folder);
    remove_old_sequence(folder);
    fs::create_directories(folder / "rgb");
    fs::create_directories(folder / "depth");
  } catch (const fs::filesystem_error& error) {
    throw OutputError(
        folder, fmt::format("cannot be prepared ({}); check permissions", error.code().message()));
  }
}

}  // namespace cvo_slam::synthetic
