// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The only source of randomness of the simulator. A seed gives the same bytes with every standard
// library, which the distributions of <random> do not promise.
#pragma once

#include <cstddef>
#include <cstdint>

#include <opencv2/core/mat.hpp>

namespace cvo_slam::synthetic {

// A hash of lattice coordinates in two steps, so that neighbours on the lattice share the first:
// lattice_position(x + 1, y) = lattice_position(x, y) + kStepX.

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

/// Returns a hash as a number in [0, 1).
inline double unit(std::uint32_t bits) {
  constexpr double kScale = 1.0 / 4294967296.0;
  return bits * kScale;
}

inline double hash_unit(std::uint32_t seed, std::int32_t x, std::int32_t y = 0) {
  return unit(hash(seed, x, y));
}

/// Returns an independent seed for a purpose and a frame.
inline std::uint32_t derived_seed(std::uint32_t seed, std::int32_t purpose, std::size_t frame = 0) {
  return hash(seed, purpose, static_cast<std::int32_t>(frame));
}

/// Returns the seed of all noise of a sensor in a world.
inline std::uint32_t sensor_seed(int sensor, std::uint32_t world_seed) {
  return derived_seed(world_seed, sensor);
}

/// Returns a normally distributed number of mean 0 and variance 1 that (seed, x, y) determine. It
/// is the sum of four uniform numbers, so that its tails end at 3.5 standard deviations.
inline double normal(std::uint32_t seed, std::int32_t x, std::int32_t y = 0) {
  const std::uint32_t a = hash(seed, x, y);
  const std::uint32_t b = mixed(a + kStepX);
  // Each half word is uniform in [0, 65535], with variance 65536^2 / 12.
  constexpr double kMean = 2 * 65535.0;
  constexpr double kScale = 1.7320508075688772 / 65536;  // sqrt(12 / 4)
  const std::uint32_t sum = (a & 0xFFFFU) + (a >> 16U) + (b & 0xFFFFU) + (b >> 16U);
  return kScale * (sum - kMean);
}

/// Returns an image (CV_32FC1) of normally distributed numbers of mean 0 and variance 1: white
/// noise smoothed by a Gaussian of standard deviation `correlation` [px]; 0 = white noise.
[[nodiscard]] cv::Mat noise_field(std::uint32_t seed, const cv::Size& size, double correlation);

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
