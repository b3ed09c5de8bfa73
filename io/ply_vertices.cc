// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/numbers.h"
#include "cvo_slam/io/ply_vertices_internal.h"
#include "cvo_slam/io/text_internal.h"

namespace cvo_slam {
namespace {

static_assert(std::endian::native == std::endian::little,
              "values are copied without swapping bytes");

template <typename T>
double value_at(const char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return static_cast<double>(value);
}

double value_at(const char* bytes, PlyType type) {
  switch (type) {
    case PlyType::kInt8:
      return value_at<std::int8_t>(bytes);
    case PlyType::kUint8:
      return value_at<std::uint8_t>(bytes);
    case PlyType::kInt16:
      return value_at<std::int16_t>(bytes);
    case PlyType::kUint16:
      return value_at<std::uint16_t>(bytes);
    case PlyType::kInt32:
      return value_at<std::int32_t>(bytes);
    case PlyType::kUint32:
      return value_at<std::uint32_t>(bytes);
    case PlyType::kFloat:
      return value_at<float>(bytes);
    case PlyType::kDouble:
      return value_at<double>(bytes);
  }
  return 0;
}

using Visit = std::function<void(const PlyVertex&)>;

void visit_binary(const std::filesystem::path& file, const PlyHeader& header, std::string_view text,
                  const Visit& visit) {
  const std::size_t size = header.bytes_per_vertex();
  const std::size_t rest = text.size() - header.size;
  // Division instead of multiplication: the number of vertices in a bad file may overflow.
  if (header.bytes_before > rest || header.vertices > (rest - header.bytes_before) / size) {
    throw InputError(
        file, fmt::format("ends at byte {}, but its header promises {} vertices of {} bytes "
                          "behind {} bytes of other elements, from byte {}; the file is cut "
                          "off: copy or write it again",
                          text.size(), header.vertices, size, header.bytes_before, header.size));
  }
  const char* bytes = text.data() + header.size + header.bytes_before;
  PlyVertex vertex;
  for (std::size_t i = 0; i < header.vertices; ++i) {
    for (const PlyProperty& property : header.properties) {
      vertex[property.meaning] = value_at(bytes, property.type);
      bytes += size_of(property.type);
    }
    visit(vertex);
  }
}

/// Takes the lines behind the header one after the other.
class PlyLines {
 public:
  PlyLines(std::string_view text, long number) : text_(text), number_(number) {}

  [[nodiscard]] long number() const { return number_; }
  /// Returns false at the end of the file.
  bool next(std::string_view& line) {
    if (text_.empty()) return false;
    const std::size_t end = text_.find('\n');
    line = text_.substr(0, end);
    text_.remove_prefix(end == std::string_view::npos ? text_.size() : end + 1);
    ++number_;
    return true;
  }

 private:
  std::string_view text_;
  long number_;
};

/// Takes the first word off a line; empty if there is none.
std::string_view take_word(std::string_view& line) {
  constexpr std::string_view kBlanks = " \t\r\v\f";
  line.remove_prefix(std::min(line.find_first_not_of(kBlanks), line.size()));
  const std::string_view word = line.substr(0, line.find_first_of(kBlanks));
  line.remove_prefix(word.size());
  return word;
}

/// Returns what a word stands for that programs write where there is no number: nan, -inf,
/// Infinity, 1.#QNAN and -nan(ind) are some of them. Where there is none, returns nothing.
std::optional<double> parse_not_finite(std::string_view word) {
  if (!word.empty() && (word.front() == '-' || word.front() == '+')) word.remove_prefix(1);
  const std::string name = to_lower(std::string(word));
  if (name == "inf" || name == "infinity" || name.starts_with("1.#inf")) {
    return std::numeric_limits<double>::infinity();
  }
  const bool is_nan = name == "nan" || name.starts_with("nan(") || name.starts_with("1.#");
  return is_nan ? std::optional(std::numeric_limits<double>::quiet_NaN()) : std::nullopt;
}

double parse_value(const std::filesystem::path& file, long line, std::string_view word) {
  if (const auto value = parse_finite(word)) return *value;
  if (const auto value = parse_not_finite(word)) return *value;
  throw InputError(file, line,
                   fmt::format("'{}' is not a number; repair the line, or write nan for a value "
                               "that is missing",
                               word));
}

void parse_ascii_vertex(const std::filesystem::path& file, const PlyHeader& header, long number,
                        std::string_view line, PlyVertex& vertex) {
  std::size_t count = 0;
  for (std::string_view word = take_word(line); !word.empty(); word = take_word(line), ++count) {
    if (count >= header.properties.size()) continue;
    vertex[header.properties[count].meaning] = parse_value(file, number, word);
  }
  if (count == header.properties.size()) return;
  throw InputError(file, number,
                   fmt::format("a vertex of {} values, the header promises {}; repair the line",
                               count, header.properties.size()));
}

void visit_ascii(const std::filesystem::path& file, const PlyHeader& header, std::string_view text,
                 const Visit& visit) {
  PlyLines lines(text.substr(header.size), header.lines);
  std::string_view line;
  // Each number may be as large as an integer can be: their sum may overflow.
  std::size_t before = 0;
  while (before < header.lines_before && lines.next(line)) ++before;
  PlyVertex vertex;
  for (std::size_t i = 0; i < header.vertices; ++i) {
    if (!lines.next(line)) {
      throw InputError(file, lines.number(),
                       fmt::format("ends after {} of {} vertices; the file is cut off: copy or "
                                   "write it again",
                                   i, header.vertices));
    }
    parse_ascii_vertex(file, header, lines.number(), line, vertex);
    visit(vertex);
  }
}

}  // namespace

void for_each_vertex(const std::filesystem::path& file, const PlyHeader& header,
                     std::string_view text, const std::function<void(const PlyVertex&)>& visit) {
  if (header.is_binary) {
    visit_binary(file, header, text, visit);
  } else {
    visit_ascii(file, header, text, visit);
  }
}

}  // namespace cvo_slam
