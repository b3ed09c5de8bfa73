// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Text files of one record per line: words, columns, stamps.
#pragma once

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "cvo_slam/core/timestamp.h"

namespace cvo_slam {

/// What a number of a clock counts.
struct ClockUnit {
  std::string_view name;  ///< for people
  double per_second = 0;
  int decimals = 0;  ///< of a stamp
};

/// The year 2096: the latest stamp [s].
inline constexpr double kLatestStamp = 4e9;

/// Returns the unit, from seconds to nanoseconds, in which a number is a time of the years 1980 to
/// 2096; empty if there is none.
std::optional<ClockUnit> clock_unit_of(double number);

/// Returns true for a number with a comma in place of its point, as "0,5".
bool has_decimal_comma(std::string_view text);

/// Returns what an error line says of a word that is no finite number, and what to do.
std::string number_problem(std::string_view word);

/// Returns a word of a file between quotes for an error line: shortened, and with '?' for what is
/// not printable. Any file can be given by mistake.
std::string in_quotes(std::string_view word);

/// Returns the words of a line: what blanks, tabs and a carriage return separate.
std::vector<std::string> split_words(std::string_view line);

/// Returns the columns of a line of a table: what blanks separate or, in a CSV file, semicolons or
/// commas. A comma is no separator in a line with a blank that is not beside a comma.
std::vector<std::string> split_columns(const std::string& line);

std::string to_lower(std::string text);

/// A line of words.
struct TextLine {
  long number = 0;  ///< from 1
  std::vector<std::string> words;
};

/// Returns the lines of a file that are neither blank nor comments ('#'), split into columns.
std::vector<TextLine> read_word_lines(const std::filesystem::path& file);

/// Returns the time stamp that a word of a line spells. Throws InputError with the line.
Timestamp parse_stamp(const TextLine& line, std::size_t word, const std::filesystem::path& file);

/// What repair_stamp_order() had to do.
struct StampRepair {
  bool sorted = false;       ///< true if records were not in the order of their stamps
  std::size_t repeated = 0;  ///< records left out: their stamp is that of an earlier one
};

/// Sorts records by their member `stamp` and keeps the first of those with equal stamps.
template <typename Record>
StampRepair repair_stamp_order(std::vector<Record>& records) {
  StampRepair repair;
  const auto before = [](const Record& a, const Record& b) { return a.stamp < b.stamp; };
  if (!std::is_sorted(records.begin(), records.end(), before)) {
    std::stable_sort(records.begin(), records.end(), before);
    repair.sorted = true;
  }
  const auto same = [](const Record& a, const Record& b) { return a.stamp == b.stamp; };
  const auto end = std::unique(records.begin(), records.end(), same);
  repair.repeated = static_cast<std::size_t>(records.end() - end);
  records.erase(end, records.end());
  return repair;
}

/// Adds a line to `notes` for each kind of repair; `file` is the name that the notes give and
/// `lines` the number of its records.
void add_repair_notes(const StampRepair& repair, const std::string& file, std::size_t lines,
                      std::vector<std::string>& notes);

/// Repairs the order of records, with a line in `notes` for each kind of repair.
template <typename Record>
void repair_stamp_order(std::vector<Record>& records, const std::string& file,
                        std::vector<std::string>& notes) {
  const std::size_t lines = records.size();
  add_repair_notes(repair_stamp_order(records), file, lines, notes);
}

}  // namespace cvo_slam
