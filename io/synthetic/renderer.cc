// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/io/synthetic/renderer.h"

#include <algorithm>
#include <array>
#include <vector>

#include "cvo_slam/core/error.h"
#include "cvo_slam/io/synthetic/view_internal.h"

namespace cvo_slam::synthetic {
namespace {

/// What is visible at each pixel's centre.
class VisibilityImage {
 public:
  VisibilityImage(const View& view, int width, int height)
      : width_(width), height_(height), pixels_(static_cast<std::size_t>(width * height)) {
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) pixels_[index(x, y)] = view.look(x, y);
    }
  }

  [[nodiscard]] const Visible& at(int x, int y) const { return pixels_[index(x, y)]; }

  /// True where one of the eight neighbours shows another surface.
  [[nodiscard]] bool on_rim(int x, int y) const {
    const Visible& center = at(x, y);
    for (int v = std::max(0, y - 1); v <= std::min(height_ - 1, y + 1); ++v) {
      for (int u = std::max(0, x - 1); u <= std::min(width_ - 1, x + 1); ++u) {
        if (!center.same_surface(at(u, v))) return true;
      }
    }
    return false;
  }

 private:
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y * width_ + x);
  }

  int width_;
  int height_;
  std::vector<Visible> pixels_;
};

/// The mean colour of the surfaces that a grid of rays through the pixel meets. Each surface is
/// shaded once, with the number of its rays as weight.
Color supersample(const View& view, int x, int y) {
  constexpr int kSide = 3;
  constexpr int kRays = kSide * kSide;
  struct Sample {
    Visible visible;
    double u, v;
  };
  std::array<Sample, kRays> samples;
  for (int i = 0; i < kRays; ++i) {
    const double u = x + (i % kSide + 0.5) / kSide - 0.5;
    const double v = y + (i / kSide + 0.5) / kSide - 0.5;
    samples[static_cast<std::size_t>(i)] = {view.look(u, v), u, v};
  }
  Color sum = Color::Zero();
  for (auto begin = samples.begin(); begin != samples.end();) {
    const Visible first = begin->visible;
    const auto end = std::partition(begin, samples.end(), [&](const Sample& sample) {
      return sample.visible.same_surface(first);
    });
    const Sample& middle = *(begin + (end - begin) / 2);
    sum += static_cast<double>(end - begin) * view.shade(middle.visible, middle.u, middle.v, 1.0);
    begin = end;
  }
  return sum / kRays;
}

cv::Vec3f to_grey_levels(const Color& color) {
  constexpr double kWhite = 255;
  const Eigen::Array3f levels = (kWhite * color).min(kWhite).cast<float>();
  return {levels[2], levels[1], levels[0]};
}

}  // namespace

Rendering render(const Scene& scene, const PinholeCamera& camera, const SE3& T_world_camera) {
  camera.check();
  if (camera.has_distortion()) {
    throw OptionError("synthetic camera: distortion is not supported; set it to zero");
  }
  const View view(scene, camera, T_world_camera);
  const VisibilityImage visibility(view, camera.width, camera.height);
  Rendering rendering{cv::Mat(camera.height, camera.width, CV_32FC3),
                      cv::Mat(camera.height, camera.width, CV_64FC1)};
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      const Visible& visible = visibility.at(x, y);
      rendering.depth.at<double>(y, x) = visible.depth;
      const Color color =
          visibility.on_rim(x, y) ? supersample(view, x, y) : view.shade(visible, x, y, 1.0);
      rendering.color.at<cv::Vec3f>(y, x) = to_grey_levels(color);
    }
  }
  return rendering;
}

}  // namespace cvo_slam::synthetic
