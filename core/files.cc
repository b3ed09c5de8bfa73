// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/core/files.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <fstream>
#include <system_error>

#include <fmt/format.h>
#include <unistd.h>
#include <zlib.h>

#include "cvo_slam/core/error.h"

namespace cvo_slam {
namespace {

namespace fs = std::filesystem;

std::string last_system_error() { return std::generic_category().message(errno); }

/// Writes the bytes to `place`. Throws OutputError, which names `file`, if not all can be written.
void write_to(const fs::path& place, std::string_view bytes, const fs::path& file) {
  errno = 0;
  std::ofstream stream(place, std::ios::binary | std::ios::trunc);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  if (stream) return;
  throw OutputError(file, fmt::format("cannot be written: {}; check permissions and free space",
                                      errno != 0 ? last_system_error() : "unknown error"));
}

/// Returns a name in the folder of `file` that no other call uses at the same time.
fs::path name_aside(const fs::path& file) {
  static std::atomic<unsigned> calls{0};
  fs::path aside = file;
  aside += fmt::format(".part-{}-{}", getpid(), calls.fetch_add(1));
  return aside;
}

/// Returns the target of a symbolic link; the file itself if it is no link or the target is
/// unknown.
fs::path resolved(const fs::path& file) {
  std::error_code problem;
  if (!fs::is_symlink(fs::symlink_status(file, problem))) return file;
  const fs::path target = fs::weakly_canonical(file, problem);
  return problem ? file : target;
}

/// Returns true for UTF-16 of either byte order. Without a byte order mark it shows by its zeros:
/// one of the first two bytes, because these formats begin with a character of ASCII.
bool is_utf16(std::string_view bytes) {
  if (bytes.size() < 2) return false;
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) return true;
  return (bytes[0] == '\0') != (bytes[1] == '\0');
}

}  // namespace

std::string read_file(const fs::path& file) {
  std::error_code problem;
  // A folder can be opened on Linux; only reading from it fails.
  if (fs::is_directory(file, problem)) {
    throw InputError(file, "is a folder; a file is needed");
  }
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    throw InputError(file, fmt::format("cannot be opened: {}; check the path and its permissions",
                                       last_system_error()));
  }
  const auto size = fs::file_size(file, problem);  // fails for a pipe
  // One more than there should be: the end shows at once.
  constexpr std::size_t kPart = 65536;
  std::size_t wanted = problem ? kPart : size + 1;
  std::string bytes;
  while (stream) {
    const std::size_t begin = bytes.size();
    bytes.resize(begin + wanted);
    stream.read(&bytes[begin], static_cast<std::streamsize>(wanted));
    bytes.resize(begin + static_cast<std::size_t>(stream.gcount()));
    wanted = std::max(kPart, bytes.size());
  }
  if (stream.bad()) throw InputError(file, "cannot be read to its end; check the disk");
  return bytes;
}

std::string read_text_file(const std::filesystem::path& file) {
  std::string bytes = read_file(file);
  bytes.erase(0, bytes.size() - text_of(bytes, file).size());
  return bytes;
}

std::string_view text_of(std::string_view bytes, const std::filesystem::path& file) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (is_utf16(bytes)) throw InputError(file, "is UTF-16 text; save it as UTF-8");
  return bytes.substr(bytes.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0);
}

void write_file(const fs::path& file, std::string_view bytes) {
  const fs::path place = resolved(file);
  std::error_code problem;
  const fs::file_status status = fs::status(place, problem);
  if (fs::exists(status) && !fs::is_regular_file(status)) return write_to(place, bytes, file);
  const fs::path aside = name_aside(place);
  try {
    write_to(aside, bytes, file);
  } catch (const OutputError&) {
    fs::remove(aside, problem);
    throw;
  }
  if (fs::exists(status)) fs::permissions(aside, status.permissions(), problem);
  fs::rename(aside, place, problem);
  if (!problem) return;
  const std::string reason = problem.message();
  fs::remove(aside, problem);
  throw OutputError(file, fmt::format("cannot be replaced: {}; check its permissions", reason));
}

std::uint32_t crc32_of(std::string_view bytes, std::uint32_t before) {
  const auto* const first = reinterpret_cast<const Bytef*>(bytes.data());
  if (first == nullptr) return before;  // zlib would start anew
  return static_cast<std::uint32_t>(crc32_z(before, first, bytes.size()));
}

bool make_folder(const fs::path& folder) {
  std::error_code problem;
  const bool made = fs::create_directories(folder, problem);
  if (!problem) return made;
  throw OutputError(folder, fmt::format("cannot be made a folder: {}; choose another folder or "
                                        "check its permissions",
                                        problem.message()));
}

void remove_file(const fs::path& file) {
  std::error_code problem;
  fs::remove(file, problem);
  if (!problem) return;
  throw OutputError(file, fmt::format("cannot be removed: {}; choose another folder or check its "
                                      "permissions",
                                      problem.message()));
}

}  // namespace cvo_slam
