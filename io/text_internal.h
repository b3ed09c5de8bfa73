// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cvo_slam {

/// The number that the whole of `text` spells, unless it is not finite.
std::optional<double> parse_finite(std::string_view text);

/// The words of a line, which blanks, tabs and a carriage return separate.
std::vector<std::string> split_words(const std::string& line);

/// A line of words, with its number from 1.
struct TextLine {
  long number = 0;
  std::vector<std::string> words;
};

/// The lines of a file that are neither blank nor comments ('#').
std::vector<TextLine> read_word_lines(const std::filesystem::path& file);

std::string to_lower(std::string text);

}  // namespace cvo_slam
