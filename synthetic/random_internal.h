// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace cvo_slam::synthetic {

// The only source of chance in the synthetic worlds, so that a seed gives the same bytes with every
// standard library (the distributions of <random> do not).

// A hash of lattice coordinates in two steps, so that neighbours on the lattice share the first:
// position(x + 1, y) = position(x, y) + kStepX.
inline constexpr std::uint32_t kStepX = 0x85EBCA77U;
inline constexpr std::uint32_t kStepY = 0xC2B2AE3DU;

inline std::uint32_t lattice_position(std::uint32_t seed, std::int32_t x, std::int32_t y) {
  return seed * 0x9E3779B1U + static_cast<std::uint32_t>(x) * kStepX +
         static_cast<std::uint32_t>(y) * kStepY;
}

/// Mixes the bits of a lattice position.
inline std::uint32_t mixed(std::uint32_t h) {
  h ^= h >> 15U;
  h *= 0x2C1B3C6DU;
  h ^= h >> 12U;
  h *= 0x297A2D39U;
  h ^= h >> 15U;
  return h;
}

inline std::uint32_t hash(std::uint32_t seed, std::int32_t x, std::int32_t y = 0) {
  return mixed(lattice_position(seed, x, y));
}

/// A hash as a number in [0, 1).
inline double unit(std::uint32_t bits) {
  constexpr double kScale = 1.0 / 4294967296.0;
  return bits * kScale;
}

inline double hash_unit(std::uint32_t seed, std::int32_t x, std::int32_t y = 0) {
  return unit(hash(seed, x, y));
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
