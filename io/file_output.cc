// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fstream>

#include "cvo_slam/core/error.h"
#include "cvo_slam/io/file_output.h"

namespace cvo_slam {

void write_file(const std::filesystem::path& file, std::string_view bytes) {
  std::ofstream stream(file, std::ios::binary);
  stream << bytes << std::flush;
  if (!stream) throw OutputError(file, "cannot be written; check permissions and free space");
}

}  // namespace cvo_slam
