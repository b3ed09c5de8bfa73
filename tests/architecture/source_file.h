// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace cvo_slam::architecture {

enum class Language { kCpp, kScript };

/// A text whose comments and string literals are told apart from its code. All three views have
/// the lines and columns of the original; what does not belong to a view is blank there.
struct Views {
  std::string code;
  std::string strings;
  std::string comments;
};

/// Scripts are CMake, make, shell, YAML: '#' starts a comment outside of quotes, and quoted text
/// stays in `code`, because there it is arguments.
Views split_views(std::string_view text, Language language);

std::vector<std::string> split_lines(std::string_view text);

/// A file of the project, as the rules look at it.
struct SourceFile {
  SourceFile(std::string path, std::string_view text);

  [[nodiscard]] bool is_cpp() const { return language == Language::kCpp; }
  [[nodiscard]] bool is_header() const { return path.ends_with(".h"); }
  [[nodiscard]] bool is_internal_header() const { return path.ends_with("_internal.h"); }

  std::string path;  ///< relative to the source root, with '/'
  Language language;
  std::vector<std::string> lines;     ///< as written
  std::vector<std::string> code;      ///< without comments and, in C++, the insides of literals
  std::vector<std::string> comments;  ///< nothing but comments
};

/// Every C++ file, CMake file and script below `root`; build trees, results and the repository's
/// own folder are left out.
std::vector<SourceFile> read_tree(const std::filesystem::path& root);

}  // namespace cvo_slam::architecture
