// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/frontend/point_selection.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include "cvo_slam/frontend/depth_lookup_internal.h"
#include "cvo_slam/frontend/image_noise_internal.h"

namespace cvo_slam {
namespace {

/// Side of the cells that give at most one candidate each. Neighbouring pixels of one edge say the
/// same thing twice. [px]
constexpr int kCell = 4;
/// Side of a bucket [cells]. At 640x480 a round of all buckets gives 768 points.
constexpr int kBucketCells = 5;
constexpr std::size_t kBucketSize = std::size_t{kBucketCells} * kBucketCells;
/// Pixels from the border that are not used: the gradient and the depth check need neighbours. [px]
constexpr int kBorder = 4;
/// Sobel's operator gives eight times the gradient in 8-bit values a pixel.
constexpr float kGradientScale = 1.0F / 8;

/// An order of n buckets any part of which is spread over all: steps near the golden section.
std::vector<std::uint32_t> scattered(std::size_t n) {
  constexpr double kGoldenSection = 0.6180339887;
  auto step =
      std::max<std::size_t>(1, static_cast<std::size_t>(kGoldenSection * static_cast<double>(n)));
  while (std::gcd(step, n) > 1) ++step;
  std::vector<std::uint32_t> order(n);
  for (std::size_t i = 0; i < n; ++i) order[i] = static_cast<std::uint32_t>(i * step % n);
  return order;
}

std::vector<float> rays_of(const PinholeCamera& camera) {
  std::vector<float> rays;
  rays.reserve(2 * static_cast<std::size_t>(camera.width) *
               static_cast<std::size_t>(camera.height));
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      const Vector3 ray = camera.unproject({u, v});
      rays.push_back(static_cast<float>(ray.x()));
      rays.push_back(static_cast<float>(ray.y()));
    }
  }
  return rays;
}

int cells_along(int pixels) { return std::max(0, (pixels - 2 * kBorder) / kCell); }
int buckets_along(int pixels) { return (cells_along(pixels) + kBucketCells - 1) / kBucketCells; }

}  // namespace

OptionSet describe(SelectionOptions& o) {
  return OptionSet()
      .add("method", o.method,
           {{"gradient", SelectionMethod::kGradient}, {"edges", SelectionMethod::kEdges}},
           "Pixels of strongest gradient in each cell, or pixels on Canny edges as in the paper.")
      .add("min_gradient", o.min_gradient, {0, 1000}, "8-bit values a pixel",
           "Weaker gradients are noise: twice the noise of a Kinect's image after Sobel's filter.")
      .add("weak_gradient", o.weak_gradient, {0, 1000}, "8-bit values a pixel",
           "gradient: takes the place of min_gradient in an image with fewer than few_pixels. One "
           "and a half times that noise: a blank wall still has none, and is not tracked.")
      .add("few_pixels", o.few_pixels, {0, 1000000}, "cells of 4x4 pixels",
           "gradient: with fewer that reach min_gradient the pose would hang on single pixels. "
           "Scenes with texture have thousands, plain ones with furniture 300.")
      .add("noise_gradient", o.noise_gradient, {0, 100}, "",
           "gradient: weaker ones than this times the standard deviation of the image's noise are "
           "noise too. 2: a cell of 16 pixels without texture has one in 2,000 images, as Sobel's "
           "filter leaves 0.43 of the deviation in either direction.")
      .add("min_depth", o.min_depth, {0, 100}, "m", "Nearer depth is not used.")
      .add("max_depth", o.max_depth, {0.1, 1000}, "m",
           "Farther depth is not used: a Kinect's error grows with the square of depth and reaches "
           "the finest length scales there.")
      .add("max_depth_step", o.max_depth_step, {1e-3, 10}, "",
           "Largest difference of depth, as a share of it, to the pixels two around: more is a "
           "discontinuity, where colour and depth may belong to different surfaces.");
}

std::string check_images(const RgbdFrame& frame, const Camera& camera) {
  if (!frame.problem.empty()) return frame.problem;
  if (frame.color.empty()) return "the colour image is empty";
  if (frame.depth.empty()) return "the depth image is empty";
  if (frame.color.type() != CV_8UC3 && frame.color.type() != CV_8UC1) {
    return "the colour image must have 8 bits and 1 or 3 channels";
  }
  if (frame.depth.type() != CV_16UC1) return "the depth image must have 16 bits and 1 channel";
  for (const cv::Mat* image : {&frame.color, &frame.depth}) {
    if (image->cols != camera.color.width || image->rows != camera.color.height) {
      return fmt::format("the {} image has {}x{} pixels, the camera {}x{}",
                         image == &frame.color ? "colour" : "depth", image->cols, image->rows,
                         camera.color.width, camera.color.height);
    }
  }
  return {};
}

PointSelector::PointSelector(const Camera& camera, const SelectionOptions& options)
    : camera_(camera),
      options_(options),
      rays_(rays_of(camera.color)),
      bucket_columns_(buckets_along(camera.color.width)),
      round_(scattered(static_cast<std::size_t>(bucket_columns_) *
                       static_cast<std::size_t>(buckets_along(camera.color.height)))) {
  candidates_.resize(round_.size() * kBucketSize);
  next_.resize(round_.size());
}

void PointSelector::prepare(const RgbdFrame& frame) {
  color_ = frame.color;
  depth_ = frame.depth;
  if (color_.channels() == 1) {
    grey_ = color_;
  } else {
    cv::cvtColor(color_, grey_, cv::COLOR_BGR2GRAY);
  }
  cv::spatialGradient(grey_, dx_, dy_, 3);
  if (options_.method == SelectionMethod::kEdges) {
    constexpr double kLowThreshold = 50;  // on Sobel's sums: gradients of 6 and 12 values a pixel
    constexpr double kHighThreshold = 100;
    cv::Canny(dx_, dy_, edges_, kLowThreshold, kHighThreshold);
  }
  if (options_.method == SelectionMethod::kEdges) return rank(options_.min_gradient);
  // What varies more from pixel to pixel is texture; cameras in the dark are not worse.
  constexpr double kLargestNoise = 5;
  const double noise = std::min(kLargestNoise, image_noise(grey_));
  const double min_gradient = std::max(options_.min_gradient, options_.noise_gradient * noise);
  rank(min_gradient);
  const int found = std::accumulate(counts_.begin(), counts_.end(), 0);
  if (found < options_.few_pixels && options_.weak_gradient < min_gradient) {
    rank(options_.weak_gradient);
  }
}

/// Offers the strongest pixel of each cell, if it has depth, to the cell's bucket.
void PointSelector::rank(double min_gradient) {
  counts_.assign(round_.size(), 0);
  const double threshold = min_gradient / kGradientScale;
  const auto min_gradient2 = static_cast<std::int32_t>(threshold * threshold);
  const bool edges = options_.method == SelectionMethod::kEdges;
  const int columns = cells_along(camera_.color.width);
  std::vector<Candidate>& best = band_;
  for (int row = 0; row < cells_along(camera_.color.height); ++row) {
    best.assign(static_cast<std::size_t>(columns), {0, 0, min_gradient2});
    for (int v = kBorder + row * kCell; v < kBorder + (row + 1) * kCell; ++v) {
      const auto* dx = dx_.ptr<std::int16_t>(v);
      const auto* dy = dy_.ptr<std::int16_t>(v);
      const auto* edge = edges ? edges_.ptr<std::uint8_t>(v) : nullptr;
      for (int u = kBorder; u < kBorder + columns * kCell; ++u) {
        const std::int32_t gradient2 = dx[u] * dx[u] + dy[u] * dy[u];
        Candidate& strongest = best[static_cast<std::size_t>((u - kBorder) / kCell)];
        if (gradient2 > strongest.gradient2 && (edge == nullptr || edge[u] != 0)) {
          strongest = {static_cast<std::uint16_t>(u), static_cast<std::uint16_t>(v), gradient2};
        }
      }
    }
    for (int column = 0; column < columns; ++column) {
      const Candidate& strongest = best[static_cast<std::size_t>(column)];
      if (strongest.u == 0 || depth_.at<std::uint16_t>(strongest.v, strongest.u) == 0) continue;
      const int bucket = row / kBucketCells * bucket_columns_ + column / kBucketCells;
      offer(static_cast<std::size_t>(bucket), strongest);
    }
  }
}

/// Keeps a bucket's candidates sorted, equal ones in the order of the image.
void PointSelector::offer(std::size_t bucket, const Candidate& candidate) {
  Candidate* const first = candidates_.data() + bucket * kBucketSize;
  Candidate* place = first + counts_[bucket]++;
  for (; place != first && (place - 1)->gradient2 < candidate.gradient2; --place) {
    *place = *(place - 1);
  }
  *place = candidate;
}

void PointSelector::select(int count, const SE3& T_color_depth, PointCloud& cloud) {
  const DepthLookup lookup(depth_, camera_, rays_, T_color_depth, options_);
  cloud.clear();
  std::fill(next_.begin(), next_.end(), std::uint8_t{0});
  bool any_left = true;
  while (any_left) {
    any_left = false;
    for (const std::uint32_t bucket : round_) {
      while (next_[bucket] < counts_[bucket]) {
        if (cloud.size() == static_cast<std::size_t>(count)) return;
        const Candidate& candidate = candidates_[bucket * kBucketSize + next_[bucket]++];
        const auto point = lookup.point(candidate.u, candidate.v);
        if (!point) continue;
        append(candidate, *point, cloud);
        any_left = true;
        break;
      }
    }
  }
}

void PointSelector::append(const Candidate& candidate, const Vector3& point,
                           PointCloud& cloud) const {
  const auto& [u, v, gradient2] = candidate;
  cloud.x.push_back(static_cast<float>(point.x()));
  cloud.y.push_back(static_cast<float>(point.y()));
  cloud.z.push_back(static_cast<float>(point.z()));
  cloud.u.push_back(u);
  cloud.v.push_back(v);
  const int channels = color_.channels();
  for (int c = 0; c < 3; ++c) {
    const int channel = std::min(c, channels - 1);
    cloud.features[static_cast<std::size_t>(c)].push_back(
        color_.ptr<std::uint8_t>(v)[u * channels + channel]);
  }
  cloud.features[3].push_back(kGradientScale * static_cast<float>(dx_.at<std::int16_t>(v, u)));
  cloud.features[4].push_back(kGradientScale * static_cast<float>(dy_.at<std::int16_t>(v, u)));
}

PointCloud select_points(const RgbdFrame& frame, const Camera& camera, int count,
                         const SelectionOptions& options, const SE3& T_color_depth) {
  PointSelector selector(camera, options);
  selector.prepare(frame);
  PointCloud cloud;
  selector.select(count, T_color_depth, cloud);
  return cloud;
}

}  // namespace cvo_slam
