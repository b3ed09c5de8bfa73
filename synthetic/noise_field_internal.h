// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include <opencv2/core/mat.hpp>

#include "cvo_slam/synthetic/random_internal.h"
#include "cvo_slam/synthetic/sensor_options.h"

namespace cvo_slam::synthetic {

/// A normally distributed number of mean 0 and variance 1 that (seed, x, y) determine: the sum of
/// four uniform ones, whose tails end at 3.5 standard deviations.
inline double normal(std::uint32_t seed, std::int32_t x, std::int32_t y = 0) {
  const std::uint32_t a = hash(seed, x, y);
  const std::uint32_t b = mixed(a + kStepX);
  // Each half word is uniform in [0, 65535], with variance 65536^2 / 12.
  constexpr double kMean = 2 * 65535.0;
  constexpr double kScale = 1.7320508075688772 / 65536;  // sqrt(12 / 4)
  const std::uint32_t sum = (a & 0xFFFFU) + (a >> 16U) + (b & 0xFFFFU) + (b >> 16U);
  return kScale * (sum - kMean);
}

/// An image (CV_32FC1) of normally distributed numbers of mean 0 and variance 1, white noise
/// smoothed by a Gaussian with standard deviation `correlation` [px]; 0 leaves it white.
[[nodiscard]] cv::Mat noise_field(std::uint32_t seed, const cv::Size& size, double correlation);

/// Seeds of independent noise from one: another for each purpose and frame.
inline std::uint32_t derived_seed(std::uint32_t seed, std::int32_t purpose, std::size_t frame = 0) {
  return hash(seed, purpose, static_cast<std::int32_t>(frame));
}

/// The seed of all that is random about a sensor.
inline std::uint32_t sensor_seed(const SensorOptions& options, std::uint32_t world_seed) {
  return derived_seed(world_seed, options.seed);
}

}  // namespace cvo_slam::synthetic
