// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/io/file_output.h"

#include <fstream>
#include <system_error>

#include <fmt/format.h>

#include "cvo_slam/core/error.h"

namespace cvo_slam {

void write_file(const std::filesystem::path& file, std::string_view bytes) {
  std::ofstream stream(file, std::ios::binary);
  stream << bytes << std::flush;
  if (!stream) throw OutputError(file, "cannot be written; check permissions and free space");
}

bool make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  const bool made = std::filesystem::create_directories(folder, error);
  if (!error) return made;
  throw OutputError(folder, fmt::format("cannot be made a folder: {}; choose another folder or "
                                        "check its permissions",
                                        error.message()));
}

void remove_file(const std::filesystem::path& file) {
  std::error_code error;
  std::filesystem::remove(file, error);
  if (!error) return;
  throw OutputError(file, fmt::format("cannot be removed: {}; choose another folder or check its "
                                      "permissions",
                                      error.message()));
}

}  // namespace cvo_slam
