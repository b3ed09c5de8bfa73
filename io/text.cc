// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cmath>
#include <sstream>
#include <utility>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/core/numbers.h"
#include "cvo_slam/io/text_internal.h"

namespace cvo_slam {
namespace {

constexpr std::string_view kBlanks = " \t\r\v\f";

std::string_view without_blanks_around(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlanks) + 1 - begin);
}

/// Returns the fields between the separators; none if one of them has a blank inside, because the
/// character then does not separate.
std::vector<std::string> split_fields(std::string_view line, char separator) {
  std::vector<std::string> fields;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(separator, begin), line.size());
    const auto field = without_blanks_around(line.substr(begin, end - begin));
    if (field.find_first_of(kBlanks) != std::string_view::npos) return {};
    fields.emplace_back(field);
    begin = end + 1;
  }
  if (fields.size() > 1 && fields.back().empty()) fields.pop_back();
  return fields;
}

std::string stamp_problem(std::string_view word) {
  if (has_decimal_comma(word)) {
    return fmt::format("{} has a decimal comma; write stamps with a point", in_quotes(word));
  }
  const double value = std::fabs(parse_finite(word).value_or(0));
  const auto unit = clock_unit_of(value);
  if (unit && unit->per_second > 1) {
    return fmt::format(
        "{} is a time in {}, and stamps are in seconds; divide those of this file "
        "by {:.0f}",
        in_quotes(word), unit->name, unit->per_second);
  }
  if (value > kLatestStamp) {
    return fmt::format(
        "{} is no time in seconds: it is after the year 2096; convert the stamps of "
        "this file from milliseconds or nanoseconds to seconds",
        in_quotes(word));
  }
  return fmt::format(
      "{} is not a time stamp in seconds; repair or remove the line, or begin it "
      "with '#' if it is a heading",
      in_quotes(word));
}

}  // namespace

std::optional<ClockUnit> clock_unit_of(double number) {
  constexpr double kEarliest = 3.2e8;  // [s]
  constexpr std::array<ClockUnit, 4> kUnits = {{{"seconds", 1, 0},
                                                {"milliseconds", 1e3, 3},
                                                {"microseconds", 1e6, 6},
                                                {"nanoseconds", 1e9, 9}}};
  for (const ClockUnit& unit : kUnits) {
    const double seconds = number / unit.per_second;
    if (seconds >= kEarliest && seconds <= kLatestStamp) return unit;
  }
  return std::nullopt;
}

bool has_decimal_comma(std::string_view text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos) return false;
  std::string with_point(text);
  with_point[comma] = '.';
  return parse_finite(with_point).has_value();
}

std::string number_problem(std::string_view word) {
  if (has_decimal_comma(word)) {
    return fmt::format("{} has a decimal comma; write numbers with a point", in_quotes(word));
  }
  return fmt::format("{} is not a finite number; repair or remove the line", in_quotes(word));
}

std::string in_quotes(std::string_view word) {
  constexpr std::size_t kLongest = 40;
  std::string text(word.substr(0, kLongest));
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return fmt::format("'{}{}'", text, word.size() > kLongest ? "..." : "");
}

std::vector<std::string> split_words(std::string_view line) {
  const auto is_space = [](char c) { return c == ' ' || (c >= '\t' && c <= '\r'); };
  std::vector<std::string> words;
  for (const char* begin = line.begin();;) {
    begin = std::find_if_not(begin, line.end(), is_space);
    if (begin == line.end()) return words;
    const char* const end = std::find_if(begin, line.end(), is_space);
    words.emplace_back(begin, end);
    begin = end;
  }
}

std::vector<std::string> split_columns(const std::string& line) {
  for (const char separator : {';', ','}) {
    if (line.find(separator) == std::string::npos) continue;
    auto fields = split_fields(line, separator);
    if (!fields.empty()) return fields;
  }
  return split_words(line);
}

std::string to_lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return text;
}

std::vector<TextLine> read_word_lines(const std::filesystem::path& file) {
  std::istringstream stream(read_text_file(file));
  std::vector<TextLine> lines;
  long number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    const std::size_t first = line.find_first_not_of(kBlanks);
    if (first == std::string::npos || line[first] == '#') continue;
    lines.push_back({number, split_columns(line)});
  }
  return lines;
}

Timestamp parse_stamp(const TextLine& line, std::size_t word, const std::filesystem::path& file) {
  const auto stamp = Timestamp::parse(line.words[word]);
  if (stamp) return *stamp;
  throw InputError(file, line.number, stamp_problem(line.words[word]));
}

void add_repair_notes(const StampRepair& repair, const std::string& file, std::size_t lines,
                      std::vector<std::string>& notes) {
  if (repair.sorted) notes.push_back(fmt::format("{}: stamps out of order; sorted", file));
  if (repair.repeated == 0) return;
  notes.push_back(fmt::format("{}: {} duplicated stamps in {} lines; the later ones are left out",
                              file, repair.repeated, lines));
}

}  // namespace cvo_slam
