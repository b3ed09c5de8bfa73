// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <string_view>
#include <type_traits>

#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/loop/vocabulary.h"

namespace cvo_slam {
namespace {

constexpr std::string_view kMagic = "cvo-voc\n";
constexpr std::uint32_t kVersion = 1;
constexpr std::size_t kChecksumAt = 32;
constexpr std::size_t kHeaderBytes = 40;

template <typename Unsigned>
void append_bytes(std::string& bytes, Unsigned value) {
  for (std::size_t i = 0; i < sizeof(value); ++i) {
    bytes.push_back(static_cast<char>(static_cast<unsigned char>(value >> (8 * i))));
  }
}

template <typename Unsigned>
Unsigned number_at(std::span<const char> bytes, std::size_t offset) {
  static_assert(std::is_unsigned_v<Unsigned>);
  Unsigned value = 0;
  for (std::size_t i = 0; i < sizeof(value); ++i) {
    const auto byte = static_cast<Unsigned>(static_cast<unsigned char>(bytes[offset + i]));
    value = static_cast<Unsigned>(value | (byte << (8 * i)));
  }
  return value;
}

std::uint64_t add_to_checksum(std::uint64_t sum, std::span<const char> bytes) {
  constexpr std::uint64_t kPrime = 0x100000001b3U;
  std::size_t i = 0;
  for (; i + 8 <= bytes.size(); i += 8) {
    sum = (sum ^ number_at<std::uint64_t>(bytes, i)) * kPrime;
  }
  std::array<char, 8> rest{};
  std::copy(bytes.begin() + static_cast<std::ptrdiff_t>(i), bytes.end(), rest.begin());
  if (i < bytes.size()) sum = (sum ^ number_at<std::uint64_t>(rest, 0)) * kPrime;
  return sum;
}

/// Returns the checksum of all bytes except the checksum itself.
std::uint64_t checksum(std::span<const char> bytes) {
  constexpr std::uint64_t kBasis = 0xcbf29ce484222325U;
  const std::uint64_t header = add_to_checksum(kBasis, bytes.first(kChecksumAt));
  return add_to_checksum(header, bytes.subspan(kHeaderBytes));
}

struct Header {
  std::uint32_t version, branching, levels, bits, nodes, words;

  explicit Header(std::span<const char> bytes)
      : version(number_at<std::uint32_t>(bytes, 8)),
        branching(number_at<std::uint32_t>(bytes, 12)),
        levels(number_at<std::uint32_t>(bytes, 16)),
        bits(number_at<std::uint32_t>(bytes, 20)),
        nodes(number_at<std::uint32_t>(bytes, 24)),
        words(number_at<std::uint32_t>(bytes, 28)) {}

  [[nodiscard]] std::uint64_t descriptors_at() const { return kHeaderBytes + std::uint64_t{nodes}; }
  [[nodiscard]] std::uint64_t weights_at() const {
    return descriptors_at() + Descriptor::kBytes * (std::uint64_t{nodes} - 1);
  }
  [[nodiscard]] std::uint64_t file_bytes() const { return weights_at() + 4 * std::uint64_t{words}; }
};

/// Returns why the header is none of a file of so many bytes; an empty text if it may be one. The
/// numbers of nodes and words are those of the file from then on.
std::string header_problem(const Header& header, std::size_t bytes) {
  if (header.version != kVersion) {
    return fmt::format(
        "is of version {} of the format (byte 8), and this program knows {}; update "
        "it",
        header.version, kVersion);
  }
  if (header.bits != Descriptor::kBits) {
    return fmt::format("has descriptors of {} bits (byte 20); ORB's have {}: use another file",
                       header.bits, Descriptor::kBits);
  }
  if (header.nodes == 0) return "is damaged: it has no root (byte 24); copy it again";
  if (bytes == header.file_bytes()) return {};
  return fmt::format(
      "has {} bytes, and its header says {} ({} nodes, {} words): it is {}; copy it "
      "again",
      bytes, header.file_bytes(), header.nodes, header.words,
      bytes < header.file_bytes() ? "cut off" : "damaged");
}

/// Returns true if the bytes begin as the binary format does, as far as they go.
bool has_magic(std::span<const char> bytes) {
  const std::size_t count = std::min(bytes.size(), kMagic.size());
  return std::string_view(bytes.data(), count) == kMagic.substr(0, count);
}

/// Returns why the bytes are no vocabulary; an empty text if they are one.
std::string problem_of_bytes(std::span<const char> bytes) {
  if (bytes.size() < kHeaderBytes) {
    return fmt::format("is cut off: {} bytes, and its header has {}; copy it again", bytes.size(),
                       kHeaderBytes);
  }
  std::string problem = header_problem(Header(bytes), bytes.size());
  if (!problem.empty()) return problem;
  if (number_at<std::uint64_t>(bytes, kChecksumAt) != checksum(bytes)) {
    return "is damaged: its checksum is another; copy it again";
  }
  return {};
}

[[noreturn]] void fail_binary(const std::filesystem::path& name, const std::string& problem) {
  throw InputError(name, problem + " (read as a binary vocabulary)");
}

/// Returns the nodes that the header describes. The number of words has only been checked against
/// the size of the file.
std::vector<VocabularyNode> nodes_of(std::span<const char> bytes, const Header& header) {
  std::vector<VocabularyNode> nodes;
  nodes.reserve(header.nodes - 1);
  std::uint32_t word = 0;
  for (std::uint32_t parent = 0; parent < header.nodes; ++parent) {
    const auto children = static_cast<unsigned char>(bytes[kHeaderBytes + parent]);
    for (unsigned i = 0; i < children && nodes.size() + 1 < header.nodes; ++i) {
      const std::size_t index = nodes.size() + 1;
      VocabularyNode node;
      node.parent = parent;
      node.is_word = bytes[kHeaderBytes + index] == 0;
      const auto* descriptor =
          bytes.data() + header.descriptors_at() + Descriptor::kBytes * (index - 1);
      node.descriptor = from_bytes(std::span<const std::uint8_t, Descriptor::kBytes>(
          reinterpret_cast<const std::uint8_t*>(descriptor), Descriptor::kBytes));
      if (node.is_word && word < header.words) {
        const std::size_t weight = header.weights_at() + 4 * std::size_t{word++};
        node.weight = std::bit_cast<float>(number_at<std::uint32_t>(bytes, weight));
      }
      nodes.push_back(node);
    }
  }
  return nodes;
}

}  // namespace

std::string vocabulary_bytes(const Vocabulary& vocabulary) {
  const std::vector<VocabularyNode> nodes = vocabulary.tree();
  std::string bytes(kMagic);
  for (const auto value : {std::size_t{kVersion}, static_cast<std::size_t>(vocabulary.branching()),
                           static_cast<std::size_t>(vocabulary.levels()), Descriptor::kBits,
                           vocabulary.nodes(), vocabulary.words()}) {
    append_bytes(bytes, static_cast<std::uint32_t>(value));
  }
  append_bytes(bytes, std::uint64_t{0});
  std::string children(vocabulary.nodes(), '\0');
  for (const auto& node : nodes) ++children[node.parent];
  bytes += children;
  for (const auto& node : nodes) {
    for (const std::uint64_t word : node.descriptor.words) append_bytes(bytes, word);
  }
  for (const auto& node : nodes) {
    if (node.is_word) append_bytes(bytes, std::bit_cast<std::uint32_t>(node.weight));
  }
  std::string sum;
  append_bytes(sum, checksum(bytes));
  bytes.replace(kChecksumAt, sum.size(), sum);
  return bytes;
}

Vocabulary vocabulary_from_bytes(std::span<const char> bytes, const std::filesystem::path& name) {
  if (!has_magic(bytes)) {
    throw InputError(
        name,
        "is no vocabulary: it begins neither with 'cvo-voc' (binary) nor with a number "
        "(ORB-SLAM's text); unpack it if it is compressed, or give another file");
  }
  const std::string problem = problem_of_bytes(bytes);
  if (!problem.empty()) fail_binary(name, problem);
  const Header header(bytes);
  try {
    Vocabulary vocabulary(static_cast<int>(header.branching), static_cast<int>(header.levels),
                          nodes_of(bytes, header));
    if (vocabulary.nodes() == header.nodes && vocabulary.words() == header.words) return vocabulary;
  } catch (const DataError& error) {
    fail_binary(name, error.what());
  }
  fail_binary(name, "is damaged: its nodes are not those that its header says; copy it again");
}

Vocabulary read_vocabulary(const std::filesystem::path& file) {
  const std::string bytes = read_file(file);
  const std::string_view text = text_of(bytes, file);
  // The text format begins with a number; the binary format and other files do not.
  const bool is_text = !text.empty() && text.find_first_not_of(" \t\r\n0123456789") != 0;
  return is_text ? vocabulary_from_text(text, file) : vocabulary_from_bytes(bytes, file);
}

void write_vocabulary(const std::filesystem::path& file, const Vocabulary& vocabulary) {
  write_file(file, vocabulary_bytes(vocabulary));
}

}  // namespace cvo_slam
