// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <tuple>

#include "cvo_slam/loop/even_selection_internal.h"

namespace cvo_slam {
namespace {

/// A total order, so that no algorithm's freedom can change the result.
bool is_stronger(const cv::KeyPoint& a, const cv::KeyPoint& b) {
  return std::tuple(-a.response, a.pt.y, a.pt.x) < std::tuple(-b.response, b.pt.y, b.pt.x);
}

int cell_index(float position, int length, int cells) {
  return std::clamp(
      static_cast<int>(position * static_cast<float>(cells) / static_cast<float>(length)), 0,
      cells - 1);
}

std::vector<cv::KeyPoint> select_of_level(std::vector<cv::KeyPoint> keypoints,
                                          const cv::Size& image, const OrbOptions& options,
                                          std::size_t wanted) {
  std::sort(keypoints.begin(), keypoints.end(), is_stronger);
  if (keypoints.size() <= wanted) return keypoints;
  std::vector<int> taken(static_cast<std::size_t>(options.columns) *
                         static_cast<std::size_t>(options.rows));
  // The round in which each is taken is its rank in its cell.
  std::vector<std::pair<int, cv::KeyPoint>> ranked;
  ranked.reserve(keypoints.size());
  for (const cv::KeyPoint& keypoint : keypoints) {
    const int column = cell_index(keypoint.pt.x, image.width, options.columns);
    const int row = cell_index(keypoint.pt.y, image.height, options.rows);
    ranked.emplace_back(taken[static_cast<std::size_t>(row * options.columns + column)]++,
                        keypoint);
  }
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  keypoints.clear();
  for (std::size_t i = 0; i < wanted; ++i) keypoints.push_back(ranked[i].second);
  return keypoints;
}

/// Shares of the levels that sum to 1.
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
                                        const cv::Size& image, const OrbOptions& options) {
  std::vector<std::vector<cv::KeyPoint>> levels(static_cast<std::size_t>(options.levels));
  for (const cv::KeyPoint& keypoint : keypoints) {
    levels[static_cast<std::size_t>(keypoint.octave)].push_back(keypoint);
  }
  const std::vector<double> shares = level_shares(options);
  std::vector<cv::KeyPoint> selected;
  double due = 0;
  for (std::size_t level = levels.size(); level-- > 0;) {
    due += shares[level] * options.features;
    const auto wanted = static_cast<std::size_t>(std::lround(due)) - selected.size();
    const auto of_level = select_of_level(levels[level], image, options, wanted);
    selected.insert(selected.end(), of_level.begin(), of_level.end());
  }
  return selected;
}

}  // namespace cvo_slam
