// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <string>
#include <system_error>
#include <type_traits>

#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/loop/vocabulary.h"

namespace cvo_slam {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

/// Reads the numbers of a text, line by line.
class LineReader {
 public:
  LineReader(std::string_view text, const std::filesystem::path& name)
      : at_(text.data()), end_(text.data() + text.size()), name_(name) {}

  /// Goes to the next line that is not blank. Returns false if there is none.
  bool next_line() {
    for (++line_; at_ != end_ && (is_blank(*at_) || *at_ == '\n'); ++at_) {
      if (*at_ == '\n') ++line_;
    }
    return at_ != end_;
  }

  template <typename Number>
  Number number(const char* what) {
    while (at_ != end_ && is_blank(*at_)) ++at_;
    Number value{};
    const auto [after, problem] = std::from_chars(at_, end_, value);
    const bool ends = after == end_ || is_blank(*after) || *after == '\n';
    if (problem == std::errc::result_out_of_range && ends) {
      value = out_of_range<Number>({at_, after}, what);
    } else if (problem != std::errc() || !ends) {
      fail(fmt::format("{} is missing or no number", what));
    }
    at_ = after;
    return value;
  }

  /// Reads an integer in [min, max].
  std::uint32_t integer(const char* what, std::uint32_t min, std::uint32_t max) {
    const auto value = number<std::uint32_t>(what);
    if (value < min || value > max) {
      fail(fmt::format("{} is {}; it must be in [{}, {}]", what, value, min, max));
    }
    return value;
  }

  void end_line() {
    while (at_ != end_ && is_blank(*at_)) ++at_;
    if (at_ == end_) return;
    if (*at_ != '\n') fail("has more numbers than 'parent is_word d0 ... d31 weight'");
    ++at_;
  }

  [[noreturn]] void fail(const std::string& problem) const {
    throw InputError(name_, line_, problem + " (read as ORB-SLAM's text vocabulary)");
  }

 private:
  /// Returns 0 for a number that is too small for a float; ORB-SLAM's own files have doubles.
  template <typename Number>
  Number out_of_range(std::string_view digits, const char* what) const {
    double value = 0;
    const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    const bool small =
        std::is_floating_point_v<Number> && result.ec == std::errc() && std::fabs(value) < 1;
    if (!small) fail(fmt::format("{} is {}, which is too large", what, digits.substr(0, 40)));
    return 0;
  }

  const char* at_;
  const char* end_;
  const std::filesystem::path& name_;
  long line_ = 0;
};

VocabularyNode read_node(LineReader& line, std::uint32_t index) {
  VocabularyNode node;
  node.parent = line.integer("the parent", 0, index - 1);
  node.is_word = line.integer("is_word", 0, 1) == 1;
  DescriptorBytes bytes{};
  for (std::uint8_t& byte : bytes) {
    byte = static_cast<std::uint8_t>(line.integer("a byte of the descriptor", 0, 255));
  }
  node.descriptor = from_bytes(bytes);
  node.weight = line.number<float>("the weight");
  line.end_line();
  return node;
}

void append_digits(std::string& text, std::uint32_t number) {
  std::array<char, 16> digits{};
  const auto result = std::to_chars(digits.begin(), digits.end(), number);
  text.append(digits.data(), result.ptr);
  text.push_back(' ');
}

}  // namespace

Vocabulary vocabulary_from_text(std::string_view text, const std::filesystem::path& name) {
  LineReader line(text, name);
  if (!line.next_line()) line.fail("is empty; a vocabulary begins with its branching and levels");
  const auto branching = line.integer("the branching", 2, Vocabulary::kMaxBranching);
  const auto levels = line.integer("the number of levels", 1, Vocabulary::kMaxLevels);
  line.integer("the scoring (0 = L1 is known)", 0, 0);
  line.integer("the weighting (0 = tf-idf is known)", 0, 0);
  line.end_line();
  std::vector<VocabularyNode> nodes;
  while (line.next_line()) {
    nodes.push_back(read_node(line, static_cast<std::uint32_t>(nodes.size() + 1)));
  }
  try {
    return {static_cast<int>(branching), static_cast<int>(levels), nodes};
  } catch (const DataError& error) {
    throw InputError(name, fmt::format("{}; is the file cut off? (read as ORB-SLAM's text "
                                       "vocabulary; node n is line n + 1)",
                                       error.what()));
  }
}

void write_vocabulary_text(const std::filesystem::path& file, const Vocabulary& vocabulary) {
  std::string text = fmt::format("{} {} 0 0\n", vocabulary.branching(), vocabulary.levels());
  constexpr std::size_t kUsualLine = 140;
  text.reserve(kUsualLine * vocabulary.nodes());
  for (const VocabularyNode& node : vocabulary.tree()) {
    append_digits(text, node.parent);
    append_digits(text, node.is_word ? 1 : 0);
    for (const std::uint8_t byte : to_bytes(node.descriptor)) append_digits(text, byte);
    fmt::format_to(std::back_inserter(text), "{}\n", node.weight);
  }
  write_file(file, text);
}

}  // namespace cvo_slam
