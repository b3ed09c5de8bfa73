// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/synthetic/rendering.h"

namespace cvo_slam::synthetic {

struct Reprojection {
  std::size_t compared = 0;
  std::size_t occluded = 0;
  std::vector<double> depth_errors;  // relative
  std::vector<double> color_errors;  // grey levels
};

/// Moves the points of frame a to frame b and compares them with what b shows there.
inline Reprojection reproject(const Rendering& a, const Rendering& b, const SE3& T_b_a,
                              const PinholeCamera& camera) {
  Reprojection result;
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      const Vector3 point = T_b_a * (a.depth.at<double>(y, x) * camera.unproject({x, y}));
      if (point.z() < 0.1) continue;
      const Eigen::Vector2d pixel = camera.project(point);
      const int u = static_cast<int>(std::lround(pixel.x()));
      const int v = static_cast<int>(std::lround(pixel.y()));
      if (u < 1 || v < 1 || u >= camera.width - 1 || v >= camera.height - 1) continue;
      ++result.compared;
      // The depth is between those of the neighbouring pixels, unless there is a rim.
      double low = b.depth.at<double>(v, u);
      double high = low;
      for (int dv = -1; dv <= 1; ++dv) {
        for (int du = -1; du <= 1; ++du) {
          low = std::min(low, b.depth.at<double>(v + dv, u + du));
          high = std::max(high, b.depth.at<double>(v + dv, u + du));
        }
      }
      if (point.z() > 1.01 * high) {
        ++result.occluded;
        continue;
      }
      const double outside = std::max({0.0, low - point.z(), point.z() - high});
      result.depth_errors.push_back(outside / point.z());
      const cv::Vec3f difference = a.color.at<cv::Vec3f>(y, x) - b.color.at<cv::Vec3f>(v, u);
      result.color_errors.push_back(std::abs(difference[1]));
    }
  }
  return result;
}

inline double quantile(std::vector<double> values, double share) {
  const auto position = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + position, values.end());
  return values[static_cast<std::size_t>(position)];
}

/// Returns the median difference between a pixel and its neighbour to the right [grey levels].
inline double neighbor_difference(const Rendering& frame) {
  std::vector<double> differences;
  for (int y = 0; y < frame.color.rows; ++y) {
    for (int x = 0; x + 1 < frame.color.cols; ++x) {
      differences.push_back(
          std::abs(frame.color.at<cv::Vec3f>(y, x)[1] - frame.color.at<cv::Vec3f>(y, x + 1)[1]));
    }
  }
  return quantile(std::move(differences), 0.5);
}

}  // namespace cvo_slam::synthetic
