// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <vector>

#include "cvo_slam/synthetic/random_internal.h"

namespace cvo_slam::synthetic {
namespace {

/// Returns weights whose squares sum to 1, so that white noise keeps its variance.
std::vector<float> smoothing_weights(double sigma) {
  const int radius = static_cast<int>(std::ceil(2.5 * sigma));
  std::vector<double> weights;
  weights.reserve(static_cast<std::size_t>(2 * radius) + 1);
  double squares = 0;
  for (int i = -radius; i <= radius; ++i) {
    weights.push_back(sigma > 0 ? std::exp(-0.5 * i * i / (sigma * sigma)) : 1);
    squares += weights.back() * weights.back();
  }
  std::vector<float> normalized(weights.size());
  std::transform(weights.begin(), weights.end(), normalized.begin(), [squares](double weight) {
    return static_cast<float>(weight / std::sqrt(squares));
  });
  return normalized;
}

}  // namespace

cv::Mat noise_field(std::uint32_t seed, const cv::Size& size, double correlation) {
  const std::vector<float> weights = smoothing_weights(correlation);
  const int margin = static_cast<int>(weights.size()) - 1;
  // White noise that extends beyond the image is smoothed along rows, then along columns.
  cv::Mat rows = cv::Mat::zeros(size.height + margin, size.width, CV_32FC1);
  std::vector<float> white(static_cast<std::size_t>(size.width + margin));
  for (int y = 0; y < rows.rows; ++y) {
    for (std::size_t x = 0; x < white.size(); ++x) {
      white[x] = static_cast<float>(normal(seed, static_cast<std::int32_t>(x), y));
    }
    auto* row = rows.ptr<float>(y);
    for (std::size_t k = 0; k < weights.size(); ++k) {
      const float* shifted = white.data() + k;
      for (int x = 0; x < size.width; ++x) row[x] += weights[k] * shifted[x];
    }
  }
  cv::Mat field = cv::Mat::zeros(size, CV_32FC1);
  for (int y = 0; y < size.height; ++y) {
    auto* result = field.ptr<float>(y);
    for (std::size_t k = 0; k < weights.size(); ++k) {
      const auto* row = rows.ptr<float>(y + static_cast<int>(k));
      for (int x = 0; x < size.width; ++x) result[x] += weights[k] * row[x];
    }
  }
  return field;
}

}  // namespace cvo_slam::synthetic
