// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <optional>

#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/io/image_file_internal.h"
#include "cvo_slam/io/image_list_internal.h"
#include "cvo_slam/io/stamp_order_internal.h"
#include "cvo_slam/io/text_internal.h"

namespace cvo_slam {
namespace {

using Path = std::filesystem::path;

void check_words(const TextLine& line, std::size_t count, const std::string& expected,
                 const Path& list) {
  if (line.words.size() == count) return;
  throw InputError(list, line.number,
                   fmt::format("expected '{}', found {} words", expected, line.words.size()));
}

Timestamp parse_stamp(const TextLine& line, std::size_t word, const Path& list) {
  const auto stamp = Timestamp::parse(line.words[word]);
  if (stamp) return *stamp;
  throw InputError(list, line.number,
                   fmt::format("'{}' is not a time stamp in seconds", line.words[word]));
}

/// What the words of a path say of the image: depth, colour, or nothing (also where they say both).
std::optional<bool> names_depth(const std::string& path) {
  const std::string text = to_lower(path);
  const auto has = [&](const char* word) { return text.find(word) != std::string::npos; };
  const bool depth = has("depth");
  const bool color = has("rgb") || has("color") || has("colour");
  if (depth == color) return std::nullopt;
  return depth;
}

bool is_depth_first(const TextLine& line, const Path& list) {
  if (const auto first = names_depth(line.words[1])) return *first;
  if (const auto second = names_depth(line.words[3])) return !*second;
  const Path folder = list.parent_path();
  const bool first = is_depth_image(folder / line.words[1]);
  if (first != is_depth_image(folder / line.words[3])) return first;
  throw InputError(list, line.number,
                   "cannot tell the depth image: neither do the names say it, nor is exactly one "
                   "of the two files a 16-bit image");
}

}  // namespace

std::vector<StampedFile> read_image_list(const Path& list, std::vector<std::string>& notes) {
  std::vector<StampedFile> images;
  for (const auto& line : read_word_lines(list)) {
    check_words(line, 2, "stamp file", list);
    images.push_back({parse_stamp(line, 0, list), list.parent_path() / line.words[1]});
  }
  if (images.empty()) throw InputError(list, "lists no image");
  repair_stamp_order(images, list.filename().string(), notes);
  return images;
}

AssociationList read_association_list(const Path& list, std::vector<std::string>& notes) {
  const auto lines = read_word_lines(list);
  if (lines.empty()) throw InputError(list, "lists no image");
  for (const auto& line : lines) check_words(line, 4, "stamp file stamp file", list);

  AssociationList result;
  result.depth_first = is_depth_first(lines.front(), list);
  const std::size_t color = result.depth_first ? 2 : 0;
  const std::size_t depth = 2 - color;
  const Path folder = list.parent_path();
  for (const auto& line : lines) {
    result.frames.push_back({parse_stamp(line, color, list), parse_stamp(line, depth, list),
                             folder / line.words[color + 1], folder / line.words[depth + 1]});
  }
  repair_stamp_order(result.frames, list.filename().string(), notes);
  return result;
}

}  // namespace cvo_slam
