// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>

#include "cvo_slam/frontend/brightness_internal.h"

namespace cvo_slam {
namespace {

constexpr int kGridStep = 16;  // [px]
/// Darker pixels are noise, brighter ones may be cut off.
constexpr float kDarkest = 10;
constexpr float kBrightest = 245;
/// Smaller changes, as logarithms, are left to the width of the colour kernel, and a view that
/// changes makes such ones too.
constexpr float kMinJump = 0.15F;
/// Half of the changes, as logarithms, must lie this close together. Where the exposure jumps they
/// do within 0.1 to 0.2, motion included; where the view changes they do not: 0.2 to 0.5 in the
/// fast turns of fr1/rpy.
constexpr float kMaxSpread = 0.25F;

float quantile(std::vector<float>& values, std::size_t quarter) {
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(values.size() * quarter / 4);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

}  // namespace

double BrightnessLevel::jump() {
  changes_.clear();
  for (std::size_t i = 0; i < next_.size(); ++i) {
    const auto [low, high] = std::minmax(last_[i], next_[i]);
    if (low < kDarkest || high > kBrightest) continue;
    changes_.push_back(std::log(next_[i] / last_[i]));
  }
  if (2 * changes_.size() < next_.size()) return 0;
  const float spread = quantile(changes_, 3) - quantile(changes_, 1);
  const float median = quantile(changes_, 2);
  return std::abs(median) > kMinJump && spread < kMaxSpread ? median : 0;
}

void BrightnessLevel::update(const cv::Mat& image) {
  next_.clear();
  const int channels = image.channels();
  for (int v = kGridStep / 2; v < image.rows; v += kGridStep) {
    const auto* row = image.ptr<std::uint8_t>(v);
    for (int u = kGridStep / 2; u < image.cols; u += kGridStep) {
      const auto* pixel = row + static_cast<std::ptrdiff_t>(u) * channels;
      next_.push_back(static_cast<float>(std::accumulate(pixel, pixel + channels, 0)) /
                      static_cast<float>(channels));
    }
  }
  if (!next_.empty() && next_.size() == last_.size()) log_factor_ += jump();
  std::swap(last_, next_);
}

double BrightnessLevel::factor() const { return std::exp(log_factor_); }

}  // namespace cvo_slam
