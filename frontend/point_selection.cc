// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/frontend/point_selection.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include "cvo_slam/frontend/depth_lookup_internal.h"
#include "cvo_slam/frontend/image_noise_internal.h"
#include "cvo_slam/frontend/surface_fit_internal.h"

namespace cvo_slam {
namespace {

/// Side of the cells that give at most one candidate each [px]. Neighbouring pixels of one edge
/// carry the same information.
constexpr int kCell = 4;
/// Side of a bucket [cells]. At 640x480 a round of all buckets gives 768 points.
constexpr int kBucketCells = 5;
constexpr std::size_t kBucketSize = std::size_t{kBucketCells} * kBucketCells;
/// Width of the border that is not used [px]: the gradient and the depth check need neighbours.
constexpr int kBorder = 4;
/// Sobel's operator gives eight times the gradient in 8-bit values a pixel.
constexpr float kGradientScale = 1.0F / 8;

/// Returns an order of n buckets any part of which is spread over all: steps near the golden
/// section.
std::vector<std::uint32_t> scattered(std::size_t n) {
  constexpr double kGoldenSection = 0.6180339887;
  auto step =
      std::max<std::size_t>(1, static_cast<std::size_t>(kGoldenSection * static_cast<double>(n)));
  while (std::gcd(step, n) > 1) ++step;
  std::vector<std::uint32_t> order(n);
  for (std::size_t i = 0; i < n; ++i) order[i] = static_cast<std::uint32_t>(i * step % n);
  return order;
}

/// Returns x/z and y/z of each pixel, row by row.
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

#if defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define CVO_SLAM_THREAD_SANITIZER
#endif
#endif

/// True if another cv::Mat shares the memory. An atomic read: another thread may let go of it.
bool is_shared(const cv::Mat& image) {
#ifdef CVO_SLAM_THREAD_SANITIZER
  // It does not see how OpenCV, which is not instrumented, lets go: no memory is used again.
  static_cast<void>(image);
  return true;
#else
  return image.u != nullptr && CV_XADD(&image.u->refcount, 0) > 1;
#endif
}

/// Copies an image into the memory of `reused`, or into new memory if that is shared.
cv::Mat copy_of(const cv::Mat& image, cv::Mat reused) {
  if (is_shared(reused)) reused.release();
  image.copyTo(reused);
  return reused;
}

RgbdFrame copy_of(const RgbdFrame& frame, RgbdFrame reused) {
  cv::Mat color = copy_of(frame.color, std::move(reused.color));
  cv::Mat depth = copy_of(frame.depth, std::move(reused.depth));
  reused = frame;
  reused.color = std::move(color);
  reused.depth = std::move(depth);
  return reused;
}

void append(const PreparedFrame& frame, const PixelCandidate& pixel, const Vector3& point,
            PointCloud& cloud) {
  const auto& [u, v, gradient2] = pixel;
  cloud.x.push_back(static_cast<float>(point.x()));
  cloud.y.push_back(static_cast<float>(point.y()));
  cloud.z.push_back(static_cast<float>(point.z()));
  cloud.u.push_back(u);
  cloud.v.push_back(v);
  const cv::Mat& color = frame.images.color;
  const int channels = color.channels();
  for (int c = 0; c < 3; ++c) {
    const int channel = std::min(c, channels - 1);
    cloud.features[static_cast<std::size_t>(c)].push_back(
        color.ptr<std::uint8_t>(v)[u * channels + channel]);
  }
  cloud.features[3].push_back(kGradientScale * static_cast<float>(frame.dx.at<std::int16_t>(v, u)));
  cloud.features[4].push_back(kGradientScale * static_cast<float>(frame.dy.at<std::int16_t>(v, u)));
}

void scale_colors(double factor, PointCloud& cloud) {
  if (factor == 1) return;
  for (auto& feature : cloud.features) {
    for (float& value : feature) value *= static_cast<float>(factor);
  }
}

}  // namespace

OptionSet describe(SelectionOptions& o) {
  return OptionSet()
      .add("min_depth", o.min_depth, {0, 100}, "m", "Least depth of a point.")
      .add("max_depth", o.max_depth, {0.1, 1000}, "m",
           "Largest depth of a point. A Kinect's error reaches the finest length scale at 6 m.")
      .expert()
      .add("method", o.method,
           {{"gradient", SelectionMethod::kGradient}, {"edges", SelectionMethod::kEdges}},
           "Pixels of strongest gradient in each cell, or pixels on Canny edges as in the paper.")
      .add("min_gradient", o.min_gradient, {0, 1000}, "8-bit values a pixel",
           "Least gradient of a point: twice the noise of a Kinect's image after Sobel's filter.")
      .add("weak_gradient", o.weak_gradient, {0, 1000}, "8-bit values a pixel",
           "Replaces min_gradient in an image with fewer than few_pixels (method gradient).")
      .add("few_pixels", o.few_pixels, {0, 1000000}, "cells of 4x4 pixels",
           "Number of cells that reach min_gradient below which weak_gradient applies (method "
           "gradient).")
      .add("noise_gradient", o.noise_gradient, {0, 100}, "",
           "Least gradient of a point, in standard deviations of the image noise (method "
           "gradient).")
      .add("max_depth_step", o.max_depth_step, {1e-3, 10}, "",
           "Largest difference of depth, as a share of it, to the pixels two around: a larger one "
           "is a discontinuity, where colour and depth may belong to different surfaces.");
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
  next_.resize(round_.size());
}

PreparedFrame PointSelector::prepare(const RgbdFrame& frame, PreparedFrame reused) {
  PreparedFrame result = std::move(reused);
  result.images = copy_of(frame, std::move(result.images));
  result.exposure = {};
  const cv::Mat& color = result.images.color;
  if (color.channels() > 1) cv::cvtColor(color, grey_, cv::COLOR_BGR2GRAY);
  const cv::Mat& grey = color.channels() > 1 ? grey_ : color;
  cv::spatialGradient(grey, result.dx, result.dy, 3);
  if (options_.method == SelectionMethod::kEdges) {
    constexpr double kLowThreshold = 50;  // on Sobel's sums: gradients of 6 and 12 values a pixel
    constexpr double kHighThreshold = 100;
    cv::Canny(result.dx, result.dy, edges_, kLowThreshold, kHighThreshold);
    rank(options_.min_gradient, result);
    return result;
  }
  // What varies more from pixel to pixel is texture; cameras in the dark are not worse.
  constexpr double kLargestNoise = 5;
  const double noise = std::min(kLargestNoise, image_noise(grey));
  const double min_gradient = std::max(options_.min_gradient, options_.noise_gradient * noise);
  rank(min_gradient, result);
  const int found = std::accumulate(result.counts.begin(), result.counts.end(), 0);
  if (found < options_.few_pixels && options_.weak_gradient < min_gradient) {
    rank(options_.weak_gradient, result);
  }
  return result;
}

/// Offers the strongest pixel of each cell, if it has depth, to the cell's bucket.
void PointSelector::rank(double min_gradient, PreparedFrame& frame) {
  frame.candidates.resize(round_.size() * kBucketSize);
  frame.counts.assign(round_.size(), 0);
  const double threshold = min_gradient / kGradientScale;
  const auto min_gradient2 = static_cast<std::int32_t>(threshold * threshold);
  const bool edges = options_.method == SelectionMethod::kEdges;
  const int columns = cells_along(camera_.color.width);
  std::vector<PixelCandidate>& best = band_;
  for (int row = 0; row < cells_along(camera_.color.height); ++row) {
    best.assign(static_cast<std::size_t>(columns), {0, 0, min_gradient2});
    for (int v = kBorder + row * kCell; v < kBorder + (row + 1) * kCell; ++v) {
      const auto* dx = frame.dx.ptr<std::int16_t>(v);
      const auto* dy = frame.dy.ptr<std::int16_t>(v);
      const auto* edge = edges ? edges_.ptr<std::uint8_t>(v) : nullptr;
      for (int u = kBorder; u < kBorder + columns * kCell; ++u) {
        const std::int32_t gradient2 = dx[u] * dx[u] + dy[u] * dy[u];
        PixelCandidate& strongest = best[static_cast<std::size_t>((u - kBorder) / kCell)];
        if (gradient2 > strongest.gradient2 && (edge == nullptr || edge[u] != 0)) {
          strongest = {static_cast<std::uint16_t>(u), static_cast<std::uint16_t>(v), gradient2};
        }
      }
    }
    for (int column = 0; column < columns; ++column) {
      const PixelCandidate& strongest = best[static_cast<std::size_t>(column)];
      const bool is_point =
          strongest.u != 0 && frame.images.depth.at<std::uint16_t>(strongest.v, strongest.u) != 0;
      if (!is_point) continue;
      const int bucket = row / kBucketCells * bucket_columns_ + column / kBucketCells;
      offer(static_cast<std::size_t>(bucket), strongest, frame);
    }
  }
}

/// Keeps a bucket's candidates sorted, equal ones in the order of the image.
void PointSelector::offer(std::size_t bucket, const PixelCandidate& candidate,
                          PreparedFrame& frame) {
  PixelCandidate* const first = frame.candidates.data() + bucket * kBucketSize;
  PixelCandidate* slot = first + frame.counts[bucket]++;
  for (; slot != first && (slot - 1)->gradient2 < candidate.gradient2; --slot) {
    *slot = *(slot - 1);
  }
  *slot = candidate;
}

void PointSelector::select(const PreparedFrame& frame, int count, const SE3& T_color_depth,
                           PointCloud& cloud) {
  const DepthLookup lookup(frame.images.depth, camera_, rays_, T_color_depth, options_);
  cloud.clear();
  cloud.ray_noise.clear();
  depth_pixels_.clear();
  std::fill(next_.begin(), next_.end(), std::uint8_t{0});
  const auto wanted = static_cast<std::size_t>(count);
  bool any_left = true;
  while (any_left && cloud.size() < wanted) {
    any_left = false;
    for (const std::uint32_t bucket : round_) {
      std::optional<DepthLookup::Point> point;
      while (!point && next_[bucket] < frame.counts[bucket] && cloud.size() < wanted) {
        const PixelCandidate& pixel = frame.candidates[bucket * kBucketSize + next_[bucket]++];
        point = lookup.point(pixel.u, pixel.v);
        if (!point) continue;
        const Vector3& p = point->position;
        append(frame, pixel, p, cloud);
        cloud.ray_noise.push_back(
            static_cast<float>(camera_.noise.sigma_z(p.z()) * p.norm() / p.z()));
        depth_pixels_.push_back(point->depth_pixel);
      }
      any_left = any_left || point;
    }
  }
  scale_colors(1 / frame.exposure.gain, cloud);
  const SurfaceFit fit(frame.images.depth, camera_, rays_, options_.max_depth_step);
  fit_surfaces(fit, depth_pixels_, T_color_depth, camera_.noise, cloud);
}

PointCloud select_points(const RgbdFrame& frame, const Camera& camera, int count,
                         const SelectionOptions& options, const SE3& T_color_depth) {
  PointSelector selector(camera, options);
  PointCloud cloud;
  selector.select(selector.prepare(frame), count, T_color_depth, cloud);
  return cloud;
}

}  // namespace cvo_slam
