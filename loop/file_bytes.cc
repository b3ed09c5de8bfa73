// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cerrno>
#include <fstream>
#include <system_error>

#include "cvo_slam/core/error.h"
#include "cvo_slam/loop/file_bytes_internal.h"

namespace cvo_slam {

std::string read_bytes(const std::filesystem::path& file) {
  std::error_code problem;
  const auto size = std::filesystem::file_size(file, problem);
  if (problem) throw InputError(file, "cannot be read: " + problem.message());
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError(file, "cannot be read: " + std::generic_category().message(errno));
  std::string bytes(size, '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(size));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  return bytes;
}

void write_bytes(const std::filesystem::path& file, std::string_view bytes) {
  errno = 0;
  std::ofstream stream(file, std::ios::binary | std::ios::trunc);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.flush();
  if (!stream) {
    throw OutputError(file, "cannot be written: " + std::generic_category().message(errno));
  }
}

}  // namespace cvo_slam
