// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "cvo_slam/loop/descriptor.h"
#include "cvo_slam/loop/random_internal.h"

namespace cvo_slam {

/// Counts, for each of the 256 bits, in how many descriptors it is set. The counters are kept as
/// bit planes, so that adding a descriptor is a ripple of a few operations on whole words.
class BitCounter {
 public:
  /// Adds a descriptor, at most 2^32 - 1 of them.
  void add(const Descriptor& descriptor) {
    Descriptor carry = descriptor;
    for (std::size_t p = 0; p < planes_.size() && carry != Descriptor(); ++p) {
      for (std::size_t w = 0; w < carry.words.size(); ++w) {
        const std::uint64_t both = planes_[p].words[w] & carry.words[w];
        planes_[p].words[w] ^= carry.words[w];
        carry.words[w] = both;
      }
    }
    ++total_;
  }

  [[nodiscard]] std::uint32_t total() const { return total_; }

  /// Returns the bits that most of the descriptors have. A bit that exactly half of them have is
  /// set if its index is even, so that not all ties of two descriptors go to the same one.
  [[nodiscard]] Descriptor majority() const {
    Descriptor result;
    for (std::size_t i = 0; i < Descriptor::kBits; ++i) {
      const std::uint64_t twice = 2 * count(i);
      const bool set = twice > total_ || (twice == total_ && i % 2 == 0);
      result.words[i / 64] |= static_cast<std::uint64_t>(set) << (i % 64);
    }
    return result;
  }

 private:
  [[nodiscard]] std::uint64_t count(std::size_t bit) const {
    std::uint64_t sum = 0;
    for (std::size_t p = 0; p < planes_.size(); ++p) {
      sum |= static_cast<std::uint64_t>(planes_[p].bit(bit)) << p;
    }
    return sum;
  }

  std::array<Descriptor, 32> planes_{};
  std::uint32_t total_ = 0;
};

/// A partition of descriptors.
struct Clusters {
  std::vector<Descriptor> centers;     ///< of clusters with at least one member
  std::vector<std::uint32_t> members;  ///< index of the cluster of each descriptor
};

/// Divides the descriptors into at most k clusters by k-means of binary vectors, whose means are
/// the majorities of bits (C. Grana et al., "A fast approach for integrating ORB descriptors in the
/// bag of words model", SPIE 2013). It starts with k-means++ (D. Arthur and S. Vassilvitskii, SODA
/// 2007) and ends when no descriptor changes its cluster, or after `iterations`. If there are at
/// most k different descriptors, each is a cluster.
[[nodiscard]] Clusters cluster(std::span<const Descriptor> descriptors, int k, int iterations,
                               Random random);

}  // namespace cvo_slam
