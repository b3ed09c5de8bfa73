// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "cvo_slam/tests/architecture/finding_internal.h"
#include "cvo_slam/tests/architecture/rooms.h"

namespace cvo_slam::architecture {
namespace {

constexpr std::string_view kRoot = "cvo_slam/";

struct Include {
  std::size_t index;  // of its line, from 0
  std::string path;
  bool quoted;
};

std::vector<Include> includes_of(const SourceFile& file) {
  static const std::regex directive(R"(^\s*#\s*include\s*(["<])([^">]+)[">])");
  std::vector<Include> includes;
  for (std::size_t i = 0; i < file.lines.size(); ++i) {
    std::smatch match;
    // A commented-out directive has no '#' in the view of the code.
    const bool is_code = file.is_cpp() && file.code[i].find('#') != std::string::npos;
    if (!is_code || !std::regex_search(file.lines[i], match, directive)) continue;
    includes.push_back({i, match[2].str(), match[1].str() == "\""});
  }
  return includes;
}

/// The project's own includes, "cvo_slam/" removed.
std::vector<Include> own_includes_of(const SourceFile& file) {
  std::vector<Include> own;
  for (Include include : includes_of(file)) {
    if (!include.path.starts_with(kRoot)) continue;
    include.path.erase(0, kRoot.size());
    own.push_back(std::move(include));
  }
  return own;
}

bool may_include(const Room& from, const Room& to) {
  return from.name == to.name || std::find(from.may_include.begin(), from.may_include.end(),
                                           to.name) != from.may_include.end();
}

}  // namespace

Findings includes_are_spelled_from_the_root(const SourceFile& file) {
  // What an embedder writes: there our headers are a library's like any other, in either spelling.
  if (file.path.starts_with("tests/consumer/project/") || file.path.starts_with("apps/examples/"))
    return {};
  Findings findings;
  for (const Include& include : includes_of(file)) {
    const bool own = include.path.starts_with(kRoot);
    if (own == include.quoted) continue;
    findings.push_back(
        finding(file, include.index,
                fmt::format("include '{}': write \"cvo_slam/<room>/<file>.h\" for a header of the "
                            "project and <...> for any other",
                            include.path)));
  }
  return findings;
}

Findings includes_follow_the_table(const SourceFile& file) {
  const Room* from = room_of(file.path);
  if (from == nullptr) return {};
  Findings findings;
  for (const Include& include : own_includes_of(file)) {
    const Room* to = room_of(include.path);
    if (to != nullptr && may_include(*from, *to)) continue;
    findings.push_back(finding(
        file, include.index,
        fmt::format("include 'cvo_slam/{}': {}/ may not use {}/; move what you need, or change the "
                    "table in tests/architecture/rooms.cc and docs/architecture.md on purpose",
                    include.path, from->name,
                    to == nullptr ? include.path.substr(0, include.path.find('/')) : to->name)));
  }
  return findings;
}

Findings public_headers_include_no_internal_ones(const SourceFile& file) {
  const Room* room = room_of(file.path);
  const bool installed = room != nullptr && room->is_library && file.is_header();
  if (!installed || file.is_internal_header()) return {};
  Findings findings;
  for (const Include& include : own_includes_of(file)) {
    if (!include.path.ends_with("_internal.h")) continue;
    findings.push_back(finding(file, include.index,
                               fmt::format("include 'cvo_slam/{}': it is not installed; include it "
                                           "in the source file instead",
                                           include.path)));
  }
  return findings;
}

Findings internal_headers_stay_in_their_room(const SourceFile& file) {
  const Room* from = room_of(file.path);
  // Tests and benchmarks may look inside.
  if (from == nullptr || from->name == "tests" || from->name == "bench") return {};
  Findings findings;
  for (const Include& include : own_includes_of(file)) {
    if (!include.path.ends_with("_internal.h") || room_of(include.path) == from) continue;
    findings.push_back(finding(file, include.index,
                               fmt::format("include 'cvo_slam/{}': internal headers are for their "
                                           "own room; use its public ones",
                                           include.path)));
  }
  return findings;
}

Findings sources_live_in_a_room(const SourceFile& file) {
  if (!file.is_cpp() || room_of(file.path) != nullptr) return {};
  return {finding(file, 0,
                  "the folder is no room; add it to the table in tests/architecture/rooms.cc and "
                  "docs/architecture.md")};
}

}  // namespace cvo_slam::architecture
