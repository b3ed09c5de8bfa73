// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/core/text_files.h"

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"

namespace cvo_slam {
namespace {

/// Returns true for UTF-16 of either byte order. Without a byte order mark it shows by its zeros:
/// one of the first two bytes, because these formats begin with a character of ASCII.
bool is_utf16(std::string_view bytes) {
  if (bytes.size() < 2) return false;
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) return true;
  return (bytes[0] == '\0') != (bytes[1] == '\0');
}

}  // namespace

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

}  // namespace cvo_slam
