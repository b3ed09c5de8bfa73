// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace cvo_slam::synthetic {

/// A well-mixed hash of a seed and lattice coordinates: the only source of chance in the synthetic
/// worlds, so that a seed gives the same bytes on every machine (std distributions do not).
inline std::uint32_t hash(std::uint32_t seed, std::int32_t x, std::int32_t y = 0) {
  std::uint32_t h = seed * 0x9E3779B1U + static_cast<std::uint32_t>(x) * 0x85EBCA77U +
                    static_cast<std::uint32_t>(y) * 0xC2B2AE3DU;
  h ^= h >> 15U;
  h *= 0x2C1B3C6DU;
  h ^= h >> 12U;
  h *= 0x297A2D39U;
  h ^= h >> 15U;
  return h;
}

/// hash() as a number in [0, 1).
inline double hash_unit(std::uint32_t seed, std::int32_t x, std::int32_t y = 0) {
  constexpr double kScale = 1.0 / 4294967296.0;
  return hash(seed, x, y) * kScale;
}

/// A sequence of numbers that a seed determines.
class Random {
 public:
  explicit Random(std::uint32_t seed) : seed_(seed) {}

  std::uint32_t bits() { return hash(seed_, ++count_); }
  double uniform(double from, double to) { return from + (to - from) * hash_unit(seed_, ++count_); }

 private:
  std::uint32_t seed_;
  std::int32_t count_ = 0;
};

}  // namespace cvo_slam::synthetic
