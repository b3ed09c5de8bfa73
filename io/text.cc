// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <sstream>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/io/text_internal.h"

namespace cvo_slam {

std::optional<double> parse_finite(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
    return std::nullopt;
  }
  return value;
}

std::vector<std::string> split_words(const std::string& line) {
  std::istringstream stream(line);
  return {std::istream_iterator<std::string>(stream), {}};
}

std::string to_lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return text;
}

std::vector<TextLine> read_word_lines(const std::filesystem::path& file) {
  std::istringstream stream(read_file(file));
  std::vector<TextLine> lines;
  long number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    auto words = split_words(line);
    if (words.empty() || words.front().front() == '#') continue;
    lines.push_back({number, std::move(words)});
  }
  return lines;
}

Timestamp parse_stamp(const TextLine& line, std::size_t word, const std::filesystem::path& file) {
  const auto stamp = Timestamp::parse(line.words[word]);
  if (stamp) return *stamp;
  throw InputError(file, line.number,
                   fmt::format("'{}' is not a time stamp in seconds", line.words[word]));
}

}  // namespace cvo_slam
