// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/frontend/point_selection.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

namespace cvo_slam {
namespace {

/// Side of the cells that give at most one candidate each. Neighbouring pixels of one edge say the
/// same thing twice. [px]
constexpr int kCell = 4;
/// Pixels from the border that are not used: the gradient and the depth check need neighbours. [px]
constexpr int kBorder = 4;

struct Candidate {
  int u;
  int v;
  float gradient2;  ///< squared gradient magnitude
};

/// Grey image and its gradient by Sobel's operator, in 8-bit values a pixel.
struct Gradients {
  cv::Mat grey, dx, dy;  // CV_8U, CV_16S, CV_16S; the gradient in eighths

  explicit Gradients(const cv::Mat& color) {
    if (color.channels() == 1) {
      grey = color;
    } else {
      cv::cvtColor(color, grey, cv::COLOR_BGR2GRAY);
    }
    cv::spatialGradient(grey, dx, dy, 3);
  }

  static constexpr float kScale = 1.0F / 8;

  [[nodiscard]] float squared_magnitude(int u, int v) const {
    const float gx = kScale * dx.at<std::int16_t>(v, u);
    const float gy = kScale * dy.at<std::int16_t>(v, u);
    return gx * gx + gy * gy;
  }
};

/// Decides which depth values can be trusted.
class DepthCheck {
 public:
  DepthCheck(const cv::Mat& depth, const Camera& camera, const SelectionOptions& options)
      : depth_(depth),
        min_(static_cast<float>(options.min_depth * camera.depth_scale)),
        max_(static_cast<float>(options.max_depth * camera.depth_scale)),
        step_(static_cast<float>(options.max_depth_step)) {}

  /// True where the depth is in range and no neighbour two pixels around is much nearer or
  /// farther: at a discontinuity colour and depth may belong to different surfaces. Neighbours
  /// without depth are the shadow that structured light casts at such a place.
  [[nodiscard]] bool trusted(int u, int v) const {
    const float z = depth_.at<std::uint16_t>(v, u);
    if (!(z >= min_ && z <= max_)) return false;
    const float limit = step_ * z;
    for (int dv = -2; dv <= 2; dv += 2) {
      for (int du = -2; du <= 2; du += 2) {
        const float neighbour = depth_.at<std::uint16_t>(v + dv, u + du);
        if (neighbour == 0 || std::abs(neighbour - z) > limit) return false;
      }
    }
    return true;
  }

 private:
  const cv::Mat& depth_;
  float min_, max_, step_;
};

/// The strongest pixel of each cell that passes `allowed`.
template <typename Allowed>
std::vector<Candidate> strongest_in_cells(const Gradients& gradients, float min_gradient2,
                                          const Allowed& allowed) {
  std::vector<Candidate> candidates;
  const int width = gradients.grey.cols;
  const int height = gradients.grey.rows;
  for (int v0 = kBorder; v0 + kCell <= height - kBorder; v0 += kCell) {
    for (int u0 = kBorder; u0 + kCell <= width - kBorder; u0 += kCell) {
      Candidate best{0, 0, min_gradient2};
      for (int v = v0; v < v0 + kCell; ++v) {
        for (int u = u0; u < u0 + kCell; ++u) {
          const float gradient2 = gradients.squared_magnitude(u, v);
          if (gradient2 > best.gradient2 && allowed(u, v)) best = {u, v, gradient2};
        }
      }
      if (best.gradient2 > min_gradient2) candidates.push_back(best);
    }
  }
  return candidates;
}

/// Orders candidates in rounds, each of which takes the strongest one left of every square bucket
/// of the image, so that every prefix is evenly spread; keeps `count` of them.
void spread(std::vector<Candidate>& candidates, int width, int height, int count) {
  const double pixels = static_cast<double>(width) * height;
  const int bucket = std::max(kCell, static_cast<int>(std::sqrt(2 * pixels / count)));
  const int columns = width / bucket + 1;
  const auto bucket_of = [&](const Candidate& c) { return c.v / bucket * columns + c.u / bucket; };

  std::vector<std::uint32_t> order(candidates.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const Candidate& ca = candidates[a];
    const Candidate& cb = candidates[b];
    if (ca.gradient2 != cb.gradient2) return ca.gradient2 > cb.gradient2;
    return a < b;
  });
  std::vector<std::uint32_t> taken(static_cast<std::size_t>(columns * (height / bucket + 1)), 0);
  std::vector<std::uint32_t> round(candidates.size());
  for (const std::uint32_t i : order) {
    round[i] = taken[static_cast<std::size_t>(bucket_of(candidates[i]))]++;
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return round[a] < round[b]; });
  if (order.size() > static_cast<std::size_t>(count)) {
    order.resize(static_cast<std::size_t>(count));
  }
  std::vector<Candidate> kept;
  kept.reserve(order.size());
  for (const std::uint32_t i : order) kept.push_back(candidates[i]);
  candidates = std::move(kept);
}

PointCloud back_project(const std::vector<Candidate>& pixels, const RgbdFrame& frame,
                        const Camera& camera, const Gradients& gradients) {
  PointCloud cloud;
  cloud.resize(pixels.size());
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const auto [u, v, gradient2] = pixels[i];
    const double z = frame.depth.at<std::uint16_t>(v, u) / camera.depth_scale;
    const Vector3 p = z * camera.color.unproject({u, v});
    cloud.x[i] = static_cast<float>(p.x());
    cloud.y[i] = static_cast<float>(p.y());
    cloud.z[i] = static_cast<float>(p.z());
    cloud.u[i] = static_cast<float>(u);
    cloud.v[i] = static_cast<float>(v);
    for (int c = 0; c < 3; ++c) {
      const int channel = std::min(c, frame.color.channels() - 1);
      cloud.features[static_cast<std::size_t>(c)][i] =
          frame.color.ptr<std::uint8_t>(v)[u * frame.color.channels() + channel];
    }
    cloud.features[3][i] = Gradients::kScale * gradients.dx.at<std::int16_t>(v, u);
    cloud.features[4][i] = Gradients::kScale * gradients.dy.at<std::int16_t>(v, u);
  }
  return cloud;
}

}  // namespace

OptionSet describe(SelectionOptions& o) {
  return OptionSet()
      .add("method", o.method,
           {{"gradient", SelectionMethod::kGradient}, {"edges", SelectionMethod::kEdges}},
           "Pixels of strongest gradient in each cell, or pixels on Canny edges as in the paper.")
      .add("min_gradient", o.min_gradient, {0, 1000}, "8-bit values a pixel",
           "Weaker gradients are noise: twice the noise of a Kinect's image after Sobel's filter.")
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

PointCloud select_points(const RgbdFrame& frame, const Camera& camera, int count,
                         const SelectionOptions& options) {
  const Gradients gradients(frame.color);
  const DepthCheck depth(frame.depth, camera, options);
  const auto min_gradient2 = static_cast<float>(options.min_gradient * options.min_gradient);
  std::vector<Candidate> candidates;
  if (options.method == SelectionMethod::kGradient) {
    candidates = strongest_in_cells(gradients, min_gradient2,
                                    [&](int u, int v) { return depth.trusted(u, v); });
  } else {
    constexpr double kLowThreshold = 50;  // on Sobel's sums: gradients of 6 and 12 values a pixel
    constexpr double kHighThreshold = 100;
    cv::Mat edges;
    cv::Canny(gradients.dx, gradients.dy, edges, kLowThreshold, kHighThreshold);
    candidates = strongest_in_cells(gradients, min_gradient2, [&](int u, int v) {
      return edges.at<std::uint8_t>(v, u) != 0 && depth.trusted(u, v);
    });
  }
  spread(candidates, camera.color.width, camera.color.height, count);
  return back_project(candidates, frame, camera, gradients);
}

}  // namespace cvo_slam
