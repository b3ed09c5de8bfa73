// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "cvo_slam/frontend/image_noise_internal.h"

namespace cvo_slam {
namespace {

constexpr int kNoiseGridStep = 8;  // [px]
constexpr std::size_t kLargest = std::size_t{8} * 255;
constexpr double kGain = 6;                    // the norm of N
constexpr double kMedianOfDeviation = 0.6745;  // the median of |x| of a standard normal x

int response(const std::uint8_t* above, const std::uint8_t* row, const std::uint8_t* below) {
  return above[-1] - 2 * above[0] + above[1] - 2 * row[-1] + 4 * row[0] - 2 * row[1] + below[-1] -
         2 * below[0] + below[1];
}

}  // namespace

double image_noise(const cv::Mat& grey) {
  std::array<int, kLargest + 1> histogram{};
  int count = 0;
  for (int v = kNoiseGridStep; v + 1 < grey.rows; v += kNoiseGridStep) {
    const auto* above = grey.ptr<std::uint8_t>(v - 1);
    const auto* row = grey.ptr<std::uint8_t>(v);
    const auto* below = grey.ptr<std::uint8_t>(v + 1);
    for (int u = kNoiseGridStep; u + 1 < grey.cols; u += kNoiseGridStep) {
      ++histogram[static_cast<std::size_t>(std::abs(response(above + u, row + u, below + u)))];
      ++count;
    }
  }
  if (count == 0) return 0;
  // Responses are whole numbers: each stands for the values half a unit around it.
  std::size_t value = 0;
  int below = 0;
  while (2 * (below + histogram[value]) < count) below += histogram[value++];
  const double within = (0.5 * count - below) / histogram[value];
  const double median = value == 0 ? 0.5 * within : static_cast<double>(value) - 0.5 + within;
  return median / (kMedianOfDeviation * kGain);
}

}  // namespace cvo_slam
