// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>

#include <opencv2/core.hpp>

#include "cvo_slam/render/shading_internal.h"

namespace cvo_slam::render {
namespace {

/// Depth on a scale where a step counts by its share of the distance.
cv::Mat relative_depth(const View& view, const cv::Mat& depth) {
  cv::Mat result;
  if (view.orthographic) {
    // An orthographic eye is at no distance: as if at that of the range it sees.
    constexpr double kDepthsInRange = 4;
    depth.convertTo(result, CV_32F, kDepthsInRange);
    return result;
  }
  // 1 - near / z has the logarithm of z within.
  depth.convertTo(result, CV_32F, -1, 1);
  result = cv::max(result, 1e-6);
  cv::log(result, result);
  result *= -1;
  return result;
}

/// Sum over the neighbours of how far they are in front.
cv::Mat depth_behind_neighbours(const cv::Mat& depth, int radius) {
  cv::Mat sum = cv::Mat::zeros(depth.size(), CV_32FC1);
  const std::array<cv::Point, 4> directions = {cv::Point(1, 0), {0, 1}, {1, 1}, {1, -1}};
  for (const cv::Point& direction : directions) {
    for (const int sign : {-1, 1}) {
      const cv::Point shift = sign * radius * direction;
      const cv::Rect whole(cv::Point(0, 0), depth.size());
      const cv::Rect here = whole & (whole - shift);
      for (int v = here.y; v < here.y + here.height; ++v) {
        const auto* own = depth.ptr<float>(v);
        const auto* other = depth.ptr<float>(v + shift.y) + shift.x;
        auto* out = sum.ptr<float>(v);
        for (int u = here.x; u < here.x + here.width; ++u) {
          // A single far step must not outweigh all the others.
          out[u] += std::clamp(own[u] - other[u], 0.0F, 0.1F);
        }
      }
    }
  }
  return sum;
}

}  // namespace

void shade_by_depth(const View& view, int radius, Raster& raster) {
  constexpr double kStrength = 3.5;
  constexpr float kDarkest = 0.4F;
  cv::Mat light = depth_behind_neighbours(relative_depth(view, raster.depth), radius);
  light *= -kStrength;
  cv::exp(light, light);
  for (int v = 0; v < light.rows; ++v) {
    const auto* factors = light.ptr<float>(v);
    const auto* depths = raster.depth.ptr<float>(v);
    auto* pixels = raster.color.ptr<cv::Vec3b>(v);
    for (int u = 0; u < light.cols; ++u) {
      if (depths[u] >= 1) continue;  // the ground behind everything stays as it is
      const float factor = std::max(factors[u], kDarkest);
      for (int k = 0; k < 3; ++k) {
        pixels[u][k] = static_cast<std::uint8_t>(factor * static_cast<float>(pixels[u][k]) + 0.5F);
      }
    }
  }
}

}  // namespace cvo_slam::render
