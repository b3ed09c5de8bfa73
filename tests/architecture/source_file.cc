// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/tests/architecture/source_file.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <utility>

namespace cvo_slam::architecture {
namespace {

namespace fs = std::filesystem;

bool is_cpp_path(const fs::path& path) {
  constexpr std::array<std::string_view, 5> kExtensions = {".h", ".cc", ".hpp", ".cpp", ".cxx"};
  const std::string extension = path.extension().string();
  return std::find(kExtensions.begin(), kExtensions.end(), extension) != kExtensions.end();
}

bool is_script_path(const fs::path& path) {
  constexpr std::array<std::string_view, 4> kExtensions = {".cmake", ".in", ".sh", ".py"};
  constexpr std::array<std::string_view, 4> kNames = {"CMakeLists.txt", "CMakePresets.json",
                                                      "Makefile", "run"};
  const std::string extension = path.extension().string();
  const std::string name = path.filename().string();
  return std::find(kExtensions.begin(), kExtensions.end(), extension) != kExtensions.end() ||
         std::find(kNames.begin(), kNames.end(), name) != kNames.end();
}

bool is_foreign_folder(const fs::path& path) {
  const std::string name = path.filename().string();
  const bool hidden = name.starts_with('.') && name != ".ci" && name != ".github";
  return hidden || name == "build" || name == "results" || fs::exists(path / "CMakeCache.txt");
}

std::string read_text(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

std::vector<std::string> split_lines(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return lines;
}

SourceFile::SourceFile(std::string path_, std::string_view text)
    : path(std::move(path_)),
      language(is_cpp_path(path) ? Language::kCpp : Language::kScript),
      lines(split_lines(text)) {
  const Views views = split_views(text, language);
  code = split_lines(views.code);
  comments = split_lines(views.comments);
}

std::vector<SourceFile> read_tree(const fs::path& root) {
  std::vector<SourceFile> files;
  for (auto it = fs::recursive_directory_iterator(root); it != fs::recursive_directory_iterator();
       ++it) {
    const fs::path& path = it->path();
    if (it->is_directory() && is_foreign_folder(path)) it.disable_recursion_pending();
    if (!it->is_regular_file() || !(is_cpp_path(path) || is_script_path(path))) continue;
    files.emplace_back(path.lexically_relative(root).generic_string(), read_text(path));
  }
  std::sort(files.begin(), files.end(),
            [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
  return files;
}

}  // namespace cvo_slam::architecture
