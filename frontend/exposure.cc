// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>

#include "cvo_slam/frontend/exposure_internal.h"

namespace cvo_slam {
namespace {

constexpr int kMeanGridStep = 16;  // [px]
/// Range of usable pixels: darker ones are noise, brighter ones may be cut off.
constexpr float kDarkest = 10;
constexpr float kBrightest = 245;
/// Least jump, as a logarithm. The width of the colour kernel allows for smaller changes, and a
/// changing view makes such ones too.
constexpr float kMinJump = 0.15F;
/// Largest interquartile range of the changes, as logarithms. It is 0.1 to 0.2 if the exposure
/// jumps, motion included, and 0.2 to 0.5 if the view changes as in the fast turns of fr1/rpy.
constexpr float kMaxSpread = 0.25F;

/// Returns the quartile number `quarter` of the values, which it reorders.
float quartile(std::vector<float>& values, std::size_t quarter) {
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(values.size() * quarter / 4);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

}  // namespace

double ExposureGain::jump() {
  changes_.clear();
  for (std::size_t i = 0; i < next_.size(); ++i) {
    const auto [low, high] = std::minmax(last_[i], next_[i]);
    if (low < kDarkest || high > kBrightest) continue;
    changes_.push_back(std::log(next_[i] / last_[i]));
  }
  if (2 * changes_.size() < next_.size()) return 0;
  const float spread = quartile(changes_, 3) - quartile(changes_, 1);
  const float median = quartile(changes_, 2);
  return std::abs(median) > kMinJump && spread < kMaxSpread ? median : 0;
}

double ExposureGain::update(const cv::Mat& image) {
  next_.clear();
  const int channels = image.channels();
  for (int v = kMeanGridStep / 2; v < image.rows; v += kMeanGridStep) {
    const auto* row = image.ptr<std::uint8_t>(v);
    for (int u = kMeanGridStep / 2; u < image.cols; u += kMeanGridStep) {
      const auto* pixel = row + static_cast<std::ptrdiff_t>(u) * channels;
      next_.push_back(static_cast<float>(std::accumulate(pixel, pixel + channels, 0)) /
                      static_cast<float>(channels));
    }
  }
  if (!next_.empty() && next_.size() == last_.size()) log_gain_ += jump();
  std::swap(last_, next_);
  return std::exp(log_gain_);
}

}  // namespace cvo_slam
