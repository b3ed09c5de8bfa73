// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Text files of one record per line: words, numbers, stamps.
#pragma once

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "cvo_slam/core/timestamp.h"

namespace cvo_slam {

/// Returns the number that the whole of `text` spells; empty if it spells none or it is not finite.
std::optional<double> parse_finite(std::string_view text);

/// Returns the integer that the whole of `text` spells; empty if it spells none of this type.
template <typename Integer>
std::optional<Integer> parse_integer(std::string_view text) {
  Integer value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// Returns the words of a line: what blanks, tabs and a carriage return separate.
std::vector<std::string> split_words(const std::string& line);

std::string to_lower(std::string text);

/// A line of words.
struct TextLine {
  long number = 0;  ///< from 1
  std::vector<std::string> words;
};

/// Returns the lines of a file that are neither blank nor comments ('#').
std::vector<TextLine> read_word_lines(const std::filesystem::path& file);

/// Returns the time stamp that a word of a line spells. Throws InputError with the line.
Timestamp parse_stamp(const TextLine& line, std::size_t word, const std::filesystem::path& file);

/// Sorts records by their member `stamp` and keeps the first of those with equal stamps. Adds a
/// line to `notes` for each of the two that had to be done; `file` is the name that the notes give.
template <typename Record>
void repair_stamp_order(std::vector<Record>& records, const std::string& file,
                        std::vector<std::string>& notes) {
  const auto before = [](const Record& a, const Record& b) { return a.stamp < b.stamp; };
  if (!std::is_sorted(records.begin(), records.end(), before)) {
    std::stable_sort(records.begin(), records.end(), before);
    notes.push_back(fmt::format("{}: stamps out of order; sorted", file));
  }
  const auto same = [](const Record& a, const Record& b) { return a.stamp == b.stamp; };
  const auto end = std::unique(records.begin(), records.end(), same);
  if (end == records.end()) return;
  notes.push_back(fmt::format("{}: {} duplicated stamps; the later lines are dropped", file,
                              records.end() - end));
  records.erase(end, records.end());
}

}  // namespace cvo_slam
