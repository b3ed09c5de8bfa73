// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "cvo_slam/tests/architecture/finding_internal.h"

namespace cvo_slam::architecture {
namespace {

/// A file longer than this is two files; most have less than 240 lines. (The design's own limit.)
constexpr std::size_t kMaxLines = 400;

/// A script's first line may be "#!..."; the licence follows within three lines.
bool begins_with(const SourceFile& file, std::string_view text) {
  const std::size_t head = std::min<std::size_t>(3, file.lines.size());
  return std::any_of(file.lines.begin(), file.lines.begin() + static_cast<std::ptrdiff_t>(head),
                     [&](const std::string& line) { return line.find(text) != line.npos; });
}

}  // namespace

Findings headers_are_included_once(const SourceFile& file) {
  if (!file.is_header()) return {};
  // Highway compiles a header once for each instruction set, and has a guard for that.
  const bool guarded = std::any_of(file.code.begin(), file.code.end(), [](const std::string& line) {
    return line == "#pragma once" || line.ends_with("== defined(HWY_TARGET_TOGGLE)");
  });
  return guarded ? Findings() : Findings{finding(file, 0, "add '#pragma once' below the licence")};
}

Findings licences_are_stated(const SourceFile& file) {
  if (file.path.ends_with(".json")) return {};  // JSON has no comments
  if (begins_with(file, "SPDX-FileCopyrightText: ") &&
      begins_with(file, "SPDX-License-Identifier: BSD-3-Clause")) {
    return {};
  }
  return {finding(file, 0, "begin with the two SPDX lines of the other files")};
}

Findings files_are_short(const SourceFile& file) {
  if (file.lines.size() <= kMaxLines) return {};
  return {finding(file, kMaxLines,
                  fmt::format("{} lines; cut it into files of one concept each, at most {} lines",
                              file.lines.size(), kMaxLines))};
}

Findings nothing_is_left_to_do(const SourceFile& file) {
  static const std::regex pattern(R"(\b(TODO|FIXME|XXX|HACK)\b)");
  return find_all(file, file.comments, pattern, "do it now, or open an issue and say why it waits");
}

Findings builds_are_portable(const SourceFile& file) {
  if (file.is_cpp()) return {};
  static const std::regex pattern(
      R"(-ffast-math|-Ofast|-funsafe-math-optimizations|-fassociative-math|-march=|-mtune=|)"
      R"(-m(avx|sse|fma|native)\w*)");
  return find_all(file, file.code, pattern,
                  "it changes results between machines, and Eigen's alignment in the embedder's "
                  "program; dispatch at run time instead");
}

}  // namespace cvo_slam::architecture
