// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/numbers.h"
#include "cvo_slam/io/ply_header_internal.h"
#include "cvo_slam/io/text_internal.h"

namespace cvo_slam {
namespace {

template <typename Value, std::size_t kCount>
using Names = std::array<std::pair<std::string_view, Value>, kCount>;

constexpr Names<PlyType, 16> kTypes = {{{"char", PlyType::kInt8},
                                        {"int8", PlyType::kInt8},
                                        {"uchar", PlyType::kUint8},
                                        {"uint8", PlyType::kUint8},
                                        {"short", PlyType::kInt16},
                                        {"int16", PlyType::kInt16},
                                        {"ushort", PlyType::kUint16},
                                        {"uint16", PlyType::kUint16},
                                        {"int", PlyType::kInt32},
                                        {"int32", PlyType::kInt32},
                                        {"uint", PlyType::kUint32},
                                        {"uint32", PlyType::kUint32},
                                        {"float", PlyType::kFloat},
                                        {"float32", PlyType::kFloat},
                                        {"double", PlyType::kDouble},
                                        {"float64", PlyType::kDouble}}};

constexpr Names<PlyMeaning, 15> kMeanings = {{{"x", PlyMeaning::kX},
                                              {"y", PlyMeaning::kY},
                                              {"z", PlyMeaning::kZ},
                                              {"nx", PlyMeaning::kNx},
                                              {"ny", PlyMeaning::kNy},
                                              {"nz", PlyMeaning::kNz},
                                              {"red", PlyMeaning::kRed},
                                              {"green", PlyMeaning::kGreen},
                                              {"blue", PlyMeaning::kBlue},
                                              {"r", PlyMeaning::kRed},
                                              {"g", PlyMeaning::kGreen},
                                              {"b", PlyMeaning::kBlue},
                                              {"diffuse_red", PlyMeaning::kRed},
                                              {"diffuse_green", PlyMeaning::kGreen},
                                              {"diffuse_blue", PlyMeaning::kBlue}}};

template <typename Value, std::size_t kCount>
std::optional<Value> find(const Names<Value, kCount>& names, std::string_view name) {
  const auto* entry = std::find_if(names.begin(), names.end(),
                                   [&](const auto& candidate) { return candidate.first == name; });
  if (entry == names.end()) return std::nullopt;
  return entry->second;
}

constexpr std::size_t kMostElements = std::numeric_limits<std::size_t>::max();

/// Returns the sum, or the largest number if the sum is larger.
std::size_t bounded_sum(std::size_t a, std::size_t b) {
  return a > kMostElements - b ? kMostElements : a + b;
}

/// Returns the product, or the largest number if the product is larger.
std::size_t bounded_product(std::size_t a, std::size_t b) {
  return b != 0 && a > kMostElements / b ? kMostElements : a * b;
}

bool is_color(PlyMeaning meaning) {
  return meaning == PlyMeaning::kRed || meaning == PlyMeaning::kGreen ||
         meaning == PlyMeaning::kBlue;
}

/// Reads the header line by line.
class HeaderParser {
 public:
  HeaderParser(const std::filesystem::path& file, std::string_view text)
      : file_(file), text_(text) {}

  PlyHeader parse() {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (text_.starts_with(kByteOrderMark)) position_ = kByteOrderMark.size();
    if (!next_line() || words_ != std::vector<std::string>{"ply"}) {
      fail("does not begin with 'ply'; is it a PLY file?");
    }
    while (next_line() && (words_.empty() || words_[0] != "end_header")) {
      if (!words_.empty()) parse_line();
    }
    if (words_.empty()) fail("the header has no end_header; the file is cut off or no PLY file");
    check();
    header_.size = position_;
    header_.lines = line_;
    return header_;
  }

 private:
  enum class Element { kNone, kBeforeVertices, kVertices, kAfterVertices };

  [[noreturn]] void fail(const std::string& problem) const {
    throw InputError(file_, line_, problem);
  }

  bool next_line() {
    words_.clear();
    ++line_;
    // A file that is not PLY may have no line end for gigabytes.
    constexpr std::size_t kLongestLine = 4096;
    const std::size_t end = text_.substr(0, position_ + kLongestLine).find('\n', position_);
    if (end == std::string_view::npos) return false;
    words_ = split_words(text_.substr(position_, end - position_));
    position_ = end + 1;
    return true;
  }

  void parse_line() {
    const std::string& word = words_[0];
    if (word == "format") {
      parse_format();
    } else if (word == "element") {
      parse_element();
    } else if (word == "property") {
      parse_property();
    } else if (word != "comment" && word != "obj_info") {
      fail(fmt::format("unknown entry '{}' in the header of a PLY file; repair or remove the line",
                       word));
    }
  }

  void parse_format() {
    const std::string format = words_.size() > 1 ? words_[1] : "";
    if (format != "ascii" && format != "binary_little_endian") {
      fail(fmt::format("format '{}' is not read; write it as binary_little_endian or ascii",
                       format));
    }
    header_.is_binary = format != "ascii";
    has_format_ = true;
  }

  void parse_element() {
    if (words_.size() != 3) {
      fail("an element has a name and a count, as in 'element vertex 100'; repair the header");
    }
    const auto count = parse_integer<std::size_t>(words_[2]);
    if (!count) {
      fail(fmt::format("'{}' is not a number of elements; repair the header", words_[2]));
    }
    if (words_[1] == "vertex") {
      if (has_vertices_) fail("a second element 'vertex'; leave one in the file");
      element_ = Element::kVertices;
      header_.vertices = *count;
      has_vertices_ = true;
      return;
    }
    element_ = has_vertices_ ? Element::kAfterVertices : Element::kBeforeVertices;
    if (has_vertices_) return;
    count_before_ = *count;
    header_.lines_before = bounded_sum(header_.lines_before, *count);
  }

  void parse_property() {
    if (element_ == Element::kNone) fail("a property before any element; repair the header");
    if (element_ == Element::kAfterVertices) return;
    if (words_.size() != 3) {
      fail(words_.size() > 1 && words_[1] == "list"
               ? "lists are read only behind the vertices; write the vertices first, without lists"
               : "a property has a type and a name, as in 'property float x'; repair the header");
    }
    const auto type = find(kTypes, words_[1]);
    if (!type) {
      fail(fmt::format("unknown type '{}'; write float, double, uchar or another type of PLY",
                       words_[1]));
    }
    if (element_ == Element::kBeforeVertices) {
      header_.bytes_before =
          bounded_sum(header_.bytes_before, bounded_product(count_before_, size_of(*type)));
      return;
    }
    const auto meaning = find(kMeanings, to_lower(words_[2])).value_or(PlyMeaning::kOther);
    // Some programs call bytes char: no colour is negative.
    const bool is_byte = *type == PlyType::kInt8 && is_color(meaning);
    header_.properties.push_back({is_byte ? PlyType::kUint8 : *type, meaning, words_[2]});
  }

  void check() const {
    if (!has_format_) fail("the header has no line 'format'; is it a PLY file?");
    if (!has_vertices_) fail("the header has no element 'vertex'; only vertices are read");
    for (const auto meaning : {PlyMeaning::kX, PlyMeaning::kY, PlyMeaning::kZ}) {
      if (!header_.has(meaning)) fail("the vertices have no x, y and z; write them");
    }
  }

  const std::filesystem::path& file_;
  std::string_view text_;
  PlyHeader header_;
  Element element_ = Element::kNone;
  std::size_t count_before_ = 0;  // number of the current element, if it is before the vertices
  bool has_format_ = false;
  bool has_vertices_ = false;
  std::vector<std::string> words_;
  std::size_t position_ = 0;
  long line_ = 0;
};

}  // namespace

std::size_t size_of(PlyType type) {
  switch (type) {
    case PlyType::kInt8:
    case PlyType::kUint8:
      return 1;
    case PlyType::kInt16:
    case PlyType::kUint16:
      return 2;
    case PlyType::kInt32:
    case PlyType::kUint32:
    case PlyType::kFloat:
      return 4;
    case PlyType::kDouble:
      return 8;
  }
  return 0;
}

std::size_t PlyHeader::bytes_per_vertex() const {
  std::size_t bytes = 0;
  for (const PlyProperty& property : properties) bytes += size_of(property.type);
  return bytes;
}

bool PlyHeader::has(PlyMeaning meaning) const {
  return std::any_of(properties.begin(), properties.end(),
                     [&](const PlyProperty& property) { return property.meaning == meaning; });
}

PlyHeader parse_ply_header(const std::filesystem::path& file, std::string_view text) {
  return HeaderParser(file, text).parse();
}

}  // namespace cvo_slam
