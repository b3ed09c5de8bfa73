// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "cvo_slam/synthetic/picture_internal.h"

namespace cvo_slam::synthetic {
namespace {

/// What is visible at the centres of the pixels of the last three rows that were looked at: a row
/// and those beside it.
class VisibleRows {
 public:
  VisibleRows(int width, int height)
      : width_(width),
        height_(height),
        pixels_(static_cast<std::size_t>(kRows * width)),
        even_(pixels_.size()) {}

  void look(const View& view, int y) {
    for (int x = 0; x < width_; ++x) pixels_[index(x, y)] = view.look(x, y);
    for (int x = 0; x < width_; ++x) {
      const Visible& center = at(x, y);
      even_[index(x, y)] = (x == 0 || center.same_surface(at(x - 1, y))) &&
                           (x + 1 == width_ || center.same_surface(at(x + 1, y)));
    }
  }

  [[nodiscard]] const Visible& at(int x, int y) const { return pixels_[index(x, y)]; }

  /// True where one of the eight neighbours shows another surface.
  [[nodiscard]] bool on_rim(int x, int y) const {
    return !even_[index(x, y)] || (y > 0 && differs(x, y, y - 1)) ||
           (y + 1 < height_ && differs(x, y, y + 1));
  }

 private:
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y % kRows) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  }

  /// True where one of the three pixels about x in the `other` row shows another surface.
  [[nodiscard]] bool differs(int x, int y, int other) const {
    return !even_[index(x, other)] || !at(x, y).same_surface(at(x, other));
  }

  static constexpr int kRows = 3;
  int width_;
  int height_;
  std::vector<Visible> pixels_;
  std::vector<char> even_;  ///< the pixel and those to its left and right show one surface
};

struct Sample {
  Visible visible;
  double u, v;
};

/// What one of the rays through a pixel meets; they form a square grid.
Sample rim_sample(const View& view, int x, int y, int ray) {
  constexpr int kSide = 3;
  static_assert(kSide * kSide == kRimRays);
  const int column = ray % kSide;
  const int row = ray / kSide;
  const double u = x + (column + 0.5) / kSide - 0.5;
  const double v = y + (row + 0.5) / kSide - 0.5;
  return {view.look(u, v), u, v};
}

/// The mean colour of the surfaces that the rays through a pixel meet. Each surface is shaded once,
/// with the number of its rays as weight.
Color supersample(const View& view, int x, int y) {
  std::array<Sample, kRimRays> samples;
  for (int i = 0; i < kRimRays; ++i) {
    samples[static_cast<std::size_t>(i)] = rim_sample(view, x, y, i);
  }
  Color sum = Color::Zero();
  for (Sample* begin = samples.data(); begin != samples.data() + kRimRays;) {
    const Visible first = begin->visible;
    Sample* end = std::partition(begin, samples.data() + kRimRays, [&](const Sample& sample) {
      return sample.visible.same_surface(first);
    });
    const Sample& middle = *(begin + (end - begin) / 2);
    sum += static_cast<double>(end - begin) * view.shade(middle.visible, middle.u, middle.v, 1.0);
    begin = end;
  }
  return sum / kRimRays;
}

Color rim_color(const View& view, int x, int y, std::optional<int> ray) {
  if (!ray) return supersample(view, x, y);
  const Sample sample = rim_sample(view, x, y, *ray);
  return view.shade(sample.visible, sample.u, sample.v, 1.0);
}

cv::Vec3f to_grey_levels(const Color& color) {
  constexpr double kWhite = 255;
  const Eigen::Array3f levels = (kWhite * color).cast<float>();
  return {levels[2], levels[1], levels[0]};
}

std::int32_t surface_number(const Visible& visible) {
  constexpr std::int32_t kMaxFaces = 256;
  return visible.primitive == Visible::kNothing ? -1 : visible.primitive * kMaxFaces + visible.face;
}

Picture empty_picture(const PinholeCamera& camera, const Channels& channels) {
  const cv::Size size(camera.width, camera.height);
  const auto image = [&size](bool wanted, int type) {
    return wanted ? cv::Mat(size, type) : cv::Mat();
  };
  return {image(channels.color, CV_32FC3), image(channels.depth, CV_64FC1),
          image(channels.geometry, CV_32SC1), image(channels.geometry, CV_32FC1),
          image(channels.reflectance, CV_32FC1)};
}

void draw_row(Picture& picture, const View& view, const VisibleRows& visibility, int y,
              const Channels& channels, std::optional<int> rim_ray) {
  const int width = std::max(picture.color.cols, picture.depth.cols);
  for (int x = 0; x < width; ++x) {
    const Visible& visible = visibility.at(x, y);
    if (channels.depth) picture.depth.at<double>(y, x) = visible.depth;
    if (channels.color) {
      picture.color.at<cv::Vec3f>(y, x) =
          to_grey_levels(visibility.on_rim(x, y) ? rim_color(view, x, y, rim_ray)
                                                 : view.shade(visible, x, y, 1.0));
    }
    if (channels.geometry) {
      picture.surface.at<std::int32_t>(y, x) = surface_number(visible);
      picture.angle.at<float>(y, x) =
          std::acos(static_cast<float>(view.cosine_of_incidence(visible, x, y)));
    }
    if (channels.reflectance) {
      picture.reflectance.at<float>(y, x) =
          static_cast<float>(view.reflectance(visible, x, y, 1.0).mean());
    }
  }
}

}  // namespace

Picture draw(const PinholeCamera& camera, const ViewOfRow& view_of_row, const Channels& channels,
             std::optional<int> rim_ray) {
  Picture picture = empty_picture(camera, channels);
  VisibleRows visibility(camera.width, camera.height);
  const View* view = &view_of_row(0);
  visibility.look(*view, 0);
  for (int y = 0; y < camera.height; ++y) {
    // Whether a pixel is on a rim takes the row below it.
    const View* next = y + 1 < camera.height ? &view_of_row(y + 1) : nullptr;
    if (next != nullptr) visibility.look(*next, y + 1);
    draw_row(picture, *view, visibility, y, channels, rim_ray);
    view = next;
  }
  return picture;
}

}  // namespace cvo_slam::synthetic
