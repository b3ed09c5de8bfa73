// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <numbers>

#include <opencv2/core.hpp>

#include "cvo_slam/synthetic/color_sensor_internal.h"
#include "cvo_slam/synthetic/noise_field_internal.h"

namespace cvo_slam::synthetic {
namespace {

/// Normally distributed at each time, with variance 1, independent after `period`, and smooth.
double drift(std::uint32_t seed, double seconds, double period) {
  const double at = seconds / period;
  const double cell = std::floor(at);
  const double s = at - cell;
  // Squares of the two weights sum to 1, which keeps the variance.
  const double angle = 0.5 * std::numbers::pi * s * s * (3 - 2 * s);
  const auto index = static_cast<std::int32_t>(cell);
  return std::cos(angle) * normal(seed, index) + std::sin(angle) * normal(seed, index + 1);
}

/// Normally distributed with variance 1, and another number after each jump, of which there is one
/// in each interval.
double level(std::uint32_t seed, double seconds, double interval) {
  const double at = seconds / interval;
  const auto index = static_cast<std::int32_t>(std::floor(at));
  const double jump = index + hash_unit(derived_seed(seed, 1), index);
  return normal(seed, at < jump ? index - 1 : index);
}

}  // namespace

double exposure_gain(const ExposureOptions& options, std::uint32_t seed, double seconds) {
  return std::exp(options.drift * drift(derived_seed(seed, 1), seconds, options.drift_period) +
                  options.jump * level(derived_seed(seed, 2), seconds, options.jump_interval));
}

cv::Mat expose(const cv::Mat& light, double gain, const ImageNoiseOptions& options,
               std::uint32_t seed) {
  cv::Mat image;
  if (options.read == 0 && options.shot == 0) {
    light.convertTo(image, CV_8UC3, gain);
    return image;
  }
  image.create(light.size(), CV_8UC3);
  const double read_variance = options.read * options.read;
  const double shot_variance = options.shot * options.shot / 255;  // a grey level
  const int values = light.cols * light.channels();
  for (int y = 0; y < light.rows; ++y) {
    const auto* ideal = light.ptr<float>(y);
    auto* noisy = image.ptr<std::uint8_t>(y);
    for (int i = 0; i < values; ++i) {
      const double signal = gain * static_cast<double>(ideal[i]);
      const double sigma = std::sqrt(read_variance + shot_variance * signal);
      noisy[i] = cv::saturate_cast<std::uint8_t>(signal + sigma * normal(seed, i, y));
    }
  }
  return image;
}

}  // namespace cvo_slam::synthetic
