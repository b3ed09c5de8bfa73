// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "cvo_slam/loop/descriptor.h"

namespace cvo_slam {

/// Counts, for each of the 256 bits, in how many descriptors it is set. The counters are kept as
/// bit planes, so that adding a descriptor is a ripple of a few operations on whole words.
class BitCounter {
 public:
  /// At most 2^32 - 1 descriptors.
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

  /// The bits that most of the descriptors have; of equally many with and without, those with an
  /// even index, so that the ties of two descriptors do not all fall to one of them.
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

}  // namespace cvo_slam
