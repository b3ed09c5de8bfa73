// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/sparsity_image.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include <opencv2/core.hpp>

namespace cvo_slam {
namespace {

/// Returns the index of a cell on the Hilbert curve through a square grid of 2^bits cells a side.
/// Neighbours on the curve are neighbours in the grid.
std::uint64_t hilbert_index(std::uint32_t x, std::uint32_t y, unsigned bits) {
  std::uint64_t index = 0;
  for (unsigned bit = bits; bit-- > 0;) {
    const std::uint32_t side = 1U << bit;
    const std::uint32_t right = (x & side) != 0 ? 1 : 0;
    const std::uint32_t upper = (y & side) != 0 ? 1 : 0;
    index = index * 4 + ((3 * right) ^ upper);
    x &= side - 1;
    y &= side - 1;
    if (upper == 0) {
      if (right == 1) {
        x = side - 1 - x;
        y = side - 1 - y;
      }
      std::swap(x, y);
    }
  }
  return index;
}

/// Counts the entries in each pixel (CV_32FC1).
cv::Mat count_entries(const std::vector<KernelEntry>& entries, const std::vector<std::size_t>& rows,
                      const std::vector<std::size_t>& columns, cv::Size size) {
  const auto pixel = [](std::size_t rank, std::size_t count, int length) {
    return static_cast<int>(rank * static_cast<std::size_t>(length) / count);
  };
  cv::Mat counts = cv::Mat::zeros(size, CV_32FC1);
  for (const KernelEntry& entry : entries) {
    counts.at<float>(pixel(rows[entry.fixed], rows.size(), size.height),
                     pixel(columns[entry.moving], columns.size(), size.width)) += 1;
  }
  return counts;
}

}  // namespace

std::vector<std::size_t> ranks_along_curve(const std::vector<Eigen::Vector2d>& pixels) {
  constexpr unsigned kBits = 12;
  constexpr double kLast = (1U << kBits) - 1;
  const auto cell = [&](double coordinate) {
    return static_cast<std::uint32_t>(std::lround(std::clamp(coordinate, 0.0, kLast)));
  };
  std::vector<std::pair<std::uint64_t, std::size_t>> keys;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    keys.emplace_back(hilbert_index(cell(pixels[i].x()), cell(pixels[i].y()), kBits), i);
  }
  std::sort(keys.begin(), keys.end());
  std::vector<std::size_t> result(pixels.size());
  for (std::size_t rank = 0; rank < keys.size(); ++rank) result[keys[rank].second] = rank;
  return result;
}

cv::Mat draw_sparsity(const std::vector<KernelEntry>& entries,
                      const std::vector<std::size_t>& fixed_ranks,
                      const std::vector<std::size_t>& moving_ranks, cv::Size size) {
  const cv::Mat counts = count_entries(entries, fixed_ranks, moving_ranks, size);
  const double places =
      static_cast<double>(fixed_ranks.size()) * static_cast<double>(moving_ranks.size());
  // The largest number of entries in a pixel.
  const double most = std::max(1.0, places / size.area());
  // A single entry is grey enough to be seen in print.
  constexpr double kFirst = 0.45;
  cv::Mat image(size, CV_8UC3);
  for (int v = 0; v < size.height; ++v) {
    for (int u = 0; u < size.width; ++u) {
      const double count = counts.at<float>(v, u);
      const double share = most > 1 ? std::log(count) / std::log(most) : 1;
      const double ink = count > 0 ? kFirst + (1 - kFirst) * std::clamp(share, 0.0, 1.0) : 0;
      image.at<cv::Vec3b>(v, u) = cv::Vec3b::all(cv::saturate_cast<unsigned char>(255 * (1 - ink)));
    }
  }
  return image;
}

}  // namespace cvo_slam
