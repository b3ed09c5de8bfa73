// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <initializer_list>
#include <random>

namespace cvo_slam {

/// Seeded random numbers that are the same on every machine. The standard specifies the engine
/// exactly, but not the distributions.
class Random {
 public:
  /// Seeds that differ in any value give unrelated sequences.
  Random(std::initializer_list<std::uint64_t> seeds) : engine_(mix(seeds)) {}

  /// Returns a number in [0, n), n > 0. The bias is below n / 2^64.
  [[nodiscard]] std::uint64_t below(std::uint64_t n) { return engine_() % n; }

 private:
  /// Applies the finaliser of SplitMix64 (G. Steele et al., OOPSLA 2014) to each value in turn.
  static std::uint64_t mix(std::initializer_list<std::uint64_t> seeds) {
    std::uint64_t state = 0;
    for (const std::uint64_t seed : seeds) {
      state = (state ^ seed) + 0x9e3779b97f4a7c15U;
      state = (state ^ (state >> 30U)) * 0xbf58476d1ce4e5b9U;
      state = (state ^ (state >> 27U)) * 0x94d049bb133111ebU;
      state ^= state >> 31U;
    }
    return state;
  }

  std::mt19937_64 engine_;
};

}  // namespace cvo_slam
