// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "cvo_slam/loop/descriptor.h"

namespace cvo_slam {

/// In how many of the 256 bits two descriptors differ.
[[nodiscard]] inline int hamming_distance(const Descriptor& a, const Descriptor& b) {
  int distance = 0;
  for (std::size_t i = 0; i < a.words.size(); ++i) {
    distance += std::popcount(a.words[i] ^ b.words[i]);
  }
  return distance;
}

/// The distance to each of the candidates. SIMD code (Google Highway, chosen at run time); being
/// integers, the answers are the same on every instruction set.
/// `distances` has as many places as there are candidates.
void hamming_distances(const Descriptor& query, std::span<const Descriptor> candidates,
                       std::span<std::uint16_t> distances);

struct NearestDescriptor {
  std::size_t index = 0;  ///< the first of those that are equally near
  int distance = static_cast<int>(Descriptor::kBits) + 1;  ///< more than possible: no candidates
};

[[nodiscard]] NearestDescriptor nearest_descriptor(const Descriptor& query,
                                                   std::span<const Descriptor> candidates);

}  // namespace cvo_slam
