// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <tuple>
#include <utility>

#include "cvo_slam/loop/even_selection_internal.h"

namespace cvo_slam {
namespace {

/// A total order, so that the result does not depend on the sorting algorithm.
bool is_stronger(const cv::KeyPoint& a, const cv::KeyPoint& b) {
  return std::tuple(-a.response, a.pt.y, a.pt.x) < std::tuple(-b.response, b.pt.y, b.pt.x);
}

/// A grid of nearly square cells over an image.
class Grid {
 public:
  Grid(const cv::Size& image, std::size_t cells) : image_(image) {
    const double count = std::max<double>(1, static_cast<double>(cells));
    const double aspect = static_cast<double>(image.width) / image.height;
    columns_ = std::max(1, static_cast<int>(std::lround(std::sqrt(count * aspect))));
    rows_ = std::max(1, static_cast<int>(std::lround(count / columns_)));
  }

  [[nodiscard]] std::size_t cells() const {
    return static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  }
  [[nodiscard]] std::size_t cell_of(const cv::KeyPoint& keypoint) const {
    const auto column = static_cast<std::size_t>(place(keypoint.pt.x, image_.width, columns_));
    const auto row = static_cast<std::size_t>(place(keypoint.pt.y, image_.height, rows_));
    return row * static_cast<std::size_t>(columns_) + column;
  }

 private:
  static int place(float position, int length, int count) {
    const float share = position / static_cast<float>(length);
    return std::clamp(static_cast<int>(share * static_cast<float>(count)), 0, count - 1);
  }

  cv::Size image_;
  int columns_ = 1;
  int rows_ = 1;
};

/// Selects among the keypoints of one level.
std::vector<cv::KeyPoint> select_in_turn(std::vector<cv::KeyPoint> keypoints, const Grid& grid,
                                         std::size_t wanted) {
  std::sort(keypoints.begin(), keypoints.end(), is_stronger);
  if (keypoints.size() <= wanted) return keypoints;
  // A keypoint is taken in the round that equals its rank in its cell.
  std::vector<int> taken(grid.cells());
  std::vector<std::pair<int, cv::KeyPoint>> ranked;
  ranked.reserve(keypoints.size());
  for (const cv::KeyPoint& keypoint : keypoints) {
    ranked.emplace_back(taken[grid.cell_of(keypoint)]++, keypoint);
  }
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  keypoints.clear();
  for (std::size_t i = 0; i < wanted; ++i) keypoints.push_back(ranked[i].second);
  return keypoints;
}

/// Returns the shares of the levels, which sum to 1.
std::vector<double> level_shares(const OrbOptions& options) {
  std::vector<double> shares;
  double total = 0;
  for (int level = 0; level < options.levels; ++level) {
    shares.push_back(std::pow(options.scale, -level));
    total += shares.back();
  }
  for (double& share : shares) share /= total;
  return shares;
}

}  // namespace

std::vector<cv::KeyPoint> select_evenly(const std::vector<cv::KeyPoint>& keypoints,
                                        const cv::Size& image, const OrbOptions& options,
                                        int wanted) {
  std::vector<std::vector<cv::KeyPoint>> levels(static_cast<std::size_t>(options.levels));
  for (const cv::KeyPoint& keypoint : keypoints) {
    levels[static_cast<std::size_t>(keypoint.octave)].push_back(keypoint);
  }
  const std::vector<double> shares = level_shares(options);
  std::vector<cv::KeyPoint> selected;
  double due = 0;
  for (std::size_t level = levels.size(); level-- > 0;) {
    due += shares[level] * wanted;
    const auto quota = static_cast<std::size_t>(std::lround(due)) - selected.size();
    const Grid grid(image, quota / static_cast<std::size_t>(options.per_cell));
    const auto of_level = select_in_turn(std::move(levels[level]), grid, quota);
    selected.insert(selected.end(), of_level.begin(), of_level.end());
  }
  return selected;
}

std::vector<cv::KeyPoint> in_empty_cells(const std::vector<cv::KeyPoint>& keypoints,
                                         const std::vector<cv::KeyPoint>& others,
                                         const cv::Size& image, const OrbOptions& options) {
  const Grid grid(image, static_cast<std::size_t>(options.features / options.per_cell));
  std::vector<bool> is_empty(grid.cells(), true);
  for (const cv::KeyPoint& other : others) is_empty[grid.cell_of(other)] = false;
  std::vector<cv::KeyPoint> kept;
  std::copy_if(keypoints.begin(), keypoints.end(), std::back_inserter(kept),
               [&](const cv::KeyPoint& keypoint) { return is_empty[grid.cell_of(keypoint)]; });
  return kept;
}

}  // namespace cvo_slam
