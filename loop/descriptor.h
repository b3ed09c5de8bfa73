// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <opencv2/core/mat.hpp>

namespace cvo_slam {

/// The 256 binary tests of an ORB descriptor.
struct Descriptor {
  static constexpr std::size_t kBits = 256;         ///< number of tests
  static constexpr std::size_t kBytes = kBits / 8;  ///< size [bytes]

  /// Bit i of the descriptor is bit i % 64 of word i / 64.
  std::array<std::uint64_t, 4> words{};

  /// Returns the result of test i; i is less than kBits.
  [[nodiscard]] bool bit(std::size_t i) const { return ((words[i / 64] >> (i % 64)) & 1U) != 0; }
  /// Returns true if all bits are equal.
  bool operator==(const Descriptor&) const = default;
};

/// The bytes of a descriptor. Byte i holds bits 8 i to 8 i + 7, as in OpenCV's rows and in
/// vocabulary files.
using DescriptorBytes = std::array<std::uint8_t, Descriptor::kBytes>;
/// Returns the descriptor that has these bytes.
[[nodiscard]] Descriptor from_bytes(std::span<const std::uint8_t, Descriptor::kBytes> bytes);
/// Returns the bytes of a descriptor.
[[nodiscard]] DescriptorBytes to_bytes(const Descriptor& descriptor);

/// Returns one descriptor for each row of OpenCV's matrix, none for an empty matrix. Throws
/// DataError if the matrix is not CV_8UC1 with 32 columns.
[[nodiscard]] std::vector<Descriptor> to_descriptors(const cv::Mat& rows);

/// Returns the number of bits in which two descriptors differ.
[[nodiscard]] inline int hamming_distance(const Descriptor& a, const Descriptor& b) {
  int distance = 0;
  for (std::size_t i = 0; i < a.words.size(); ++i) {
    distance += std::popcount(a.words[i] ^ b.words[i]);
  }
  return distance;
}

/// Computes the distance to each of the candidates, with SIMD code that is chosen at run time
/// (Google Highway). The results are integers and the same on every instruction set. `distances`
/// has as many places as there are candidates.
void hamming_distances(const Descriptor& query, std::span<const Descriptor> candidates,
                       std::span<std::uint16_t> distances);

/// The candidate that is most similar to a descriptor.
struct NearestDescriptor {
  std::size_t index = 0;                                   ///< the first of equally near candidates
  int distance = static_cast<int>(Descriptor::kBits) + 1;  ///< larger than possible: no candidates
};

/// Returns the candidate with the smallest distance.
[[nodiscard]] NearestDescriptor nearest_descriptor(const Descriptor& query,
                                                   std::span<const Descriptor> candidates);

}  // namespace cvo_slam
