// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/synthetic/rendering.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <opencv2/core.hpp>

#include "cvo_slam/core/error.h"
#include "cvo_slam/synthetic/rendering_internal.h"

namespace cvo_slam::synthetic {
namespace {

/// The surfaces at the pixel centres of the last three rows that were looked at: a row and its two
/// neighbours.
class VisibleRows {
 public:
  VisibleRows(int width, int height)
      : width_(width),
        height_(height),
        pixels_(static_cast<std::size_t>(kRows * width)),
        even_(pixels_.size()) {}

  void look(const RayCaster& rays, int y) {
    for (int x = 0; x < width_; ++x) pixels_[index(x, y)] = rays.look(x, y);
    for (int x = 0; x < width_; ++x) {
      const Visible& center = at(x, y);
      const bool is_even = (x == 0 || center.same_surface(at(x - 1, y))) &&
                           (x + 1 == width_ || center.same_surface(at(x + 1, y)));
      even_[index(x, y)] = is_even ? 1 : 0;
    }
  }

  [[nodiscard]] const Visible& at(int x, int y) const { return pixels_[index(x, y)]; }

  /// Returns true if one of the eight neighbours shows another surface.
  [[nodiscard]] bool on_rim(int x, int y) const {
    return even_[index(x, y)] == 0 || (y > 0 && differs(x, y, y - 1)) ||
           (y + 1 < height_ && differs(x, y, y + 1));
  }

 private:
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y % kRows) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  }

  /// Returns true if one of the three pixels about x in the `other` row shows another surface.
  [[nodiscard]] bool differs(int x, int y, int other) const {
    return even_[index(x, other)] == 0 || !at(x, y).same_surface(at(x, other));
  }

  static constexpr int kRows = 3;
  int width_;
  int height_;
  std::vector<Visible> pixels_;
  std::vector<char> even_;  // 1 if the pixel and those to its left and right show one surface
};

struct Sample {
  Visible visible;
  double u, v;
};

/// Returns what one of the rays through a pixel meets. The rays form a square grid.
Sample rim_sample(const RayCaster& rays, int x, int y, int ray) {
  constexpr int kSide = 3;
  static_assert(kSide * kSide == kRimRays);
  const int column = ray % kSide;
  const int row = ray / kSide;
  const double u = x + (column + 0.5) / kSide - 0.5;
  const double v = y + (row + 0.5) / kSide - 0.5;
  return {rays.look(u, v), u, v};
}

/// Returns the mean colour of the surfaces that the rays through a pixel meet. Each surface is
/// shaded once and weighted by the number of its rays.
LinearColor supersample(const RayCaster& rays, int x, int y) {
  std::array<Sample, kRimRays> samples;
  for (int i = 0; i < kRimRays; ++i) {
    samples[static_cast<std::size_t>(i)] = rim_sample(rays, x, y, i);
  }
  LinearColor sum = LinearColor::Zero();
  for (Sample* begin = samples.data(); begin != samples.data() + kRimRays;) {
    const Visible first = begin->visible;
    Sample* end = std::partition(begin, samples.data() + kRimRays, [&](const Sample& sample) {
      return sample.visible.same_surface(first);
    });
    const Sample& middle = *(begin + (end - begin) / 2);
    sum += static_cast<double>(end - begin) * rays.shade(middle.visible, middle.u, middle.v, 1.0);
    begin = end;
  }
  return sum / kRimRays;
}

LinearColor rim_color(const RayCaster& rays, int x, int y, std::optional<int> ray) {
  if (!ray) return supersample(rays, x, y);
  const Sample sample = rim_sample(rays, x, y, *ray);
  return rays.shade(sample.visible, sample.u, sample.v, 1.0);
}

cv::Vec3f to_grey_levels(const LinearColor& color) {
  constexpr double kWhite = 255;
  const Eigen::Array3f levels = (kWhite * color).cast<float>();
  return {levels[2], levels[1], levels[0]};
}

std::int32_t surface_number(const Visible& visible) {
  constexpr std::int32_t kMaxFaces = 256;
  return visible.primitive == Visible::kNothing ? -1 : visible.primitive * kMaxFaces + visible.face;
}

IdealImages empty_images(const PinholeCamera& camera, const Channels& channels) {
  const cv::Size size(camera.width, camera.height);
  const auto image = [&size](bool wanted, int type) {
    return wanted ? cv::Mat(size, type) : cv::Mat();
  };
  return {image(channels.color, CV_32FC3), image(channels.depth, CV_64FC1),
          image(channels.geometry, CV_32SC1), image(channels.geometry, CV_32FC1),
          image(channels.reflectance, CV_32FC1)};
}

void fill_row(IdealImages& images, const RayCaster& rays, const VisibleRows& visibility, int y,
              const Channels& channels, std::optional<int> rim_ray) {
  const int width = std::max(images.color.cols, images.depth.cols);
  for (int x = 0; x < width; ++x) {
    const Visible& visible = visibility.at(x, y);
    if (channels.depth) images.depth.at<double>(y, x) = visible.depth;
    if (channels.color) {
      images.color.at<cv::Vec3f>(y, x) =
          to_grey_levels(visibility.on_rim(x, y) ? rim_color(rays, x, y, rim_ray)
                                                 : rays.shade(visible, x, y, 1.0));
    }
    if (channels.geometry) {
      images.surface.at<std::int32_t>(y, x) = surface_number(visible);
      images.angle.at<float>(y, x) =
          std::acos(static_cast<float>(rays.cosine_of_incidence(visible, x, y)));
    }
    if (channels.reflectance) {
      images.reflectance.at<float>(y, x) =
          static_cast<float>(rays.reflectance(visible, x, y, 1.0).mean());
    }
  }
}

bool has_movers(const WorldScene& scene) {
  return std::any_of(scene.primitives.begin(), scene.primitives.end(),
                     [](const Primitive& primitive) { return primitive.swing.has_value(); });
}

}  // namespace

RowRays::Snapshot::Snapshot(const Motion& motion, bool moves, double seconds, const RowRange& rows)
    : moved(moves ? std::optional<WorldScene>(scene_at(motion.scene, seconds)) : std::nullopt),
      rays(moved ? *moved : motion.scene, motion.camera, motion.T_world_camera(seconds), rows) {}

RowRays::RowRays(const Motion& motion, double seconds, double readout)
    : motion_(motion), seconds_(seconds), readout_(readout), moves_(has_movers(motion.scene)) {
  if (readout == 0) {
    snapshots_[0].emplace(motion, moves_, seconds, RowRange{0, motion.camera.height - 1});
  }
}

double RowRays::seconds_of_row(int y) const {
  const double share = static_cast<double>(y) / std::max(1, motion_.camera.height - 1);
  return seconds_ + readout_ * (share - 0.5);
}

const RayCaster& RowRays::of_row(int y) {
  if (readout_ == 0) return snapshots_[0]->rays;
  auto& snapshot = snapshots_[static_cast<std::size_t>(y % 2)];
  snapshot.emplace(motion_, moves_, seconds_of_row(y), RowRange{y, y});
  return snapshot->rays;
}

IdealImages cast_image(const PinholeCamera& camera, const RaysOfRow& rays_of_row,
                       const Channels& channels, std::optional<int> rim_ray) {
  IdealImages images = empty_images(camera, channels);
  VisibleRows visibility(camera.width, camera.height);
  const RayCaster* rays = &rays_of_row(0);
  visibility.look(*rays, 0);
  for (int y = 0; y < camera.height; ++y) {
    // The row below is needed to tell whether a pixel is on a rim.
    const RayCaster* next = y + 1 < camera.height ? &rays_of_row(y + 1) : nullptr;
    if (next != nullptr) visibility.look(*next, y + 1);
    fill_row(images, *rays, visibility, y, channels, rim_ray);
    rays = next;
  }
  return images;
}

Rendering render(const WorldScene& scene, const PinholeCamera& camera, const SE3& T_world_camera) {
  camera.check();
  if (camera.has_distortion()) {
    throw OptionError("synthetic camera: distortion is not supported; set it to zero");
  }
  const RayCaster rays(scene, camera, T_world_camera);
  const IdealImages images =
      cast_image(camera, [&rays](int) -> const RayCaster& { return rays; }, {});
  Rendering rendering{{}, images.depth};
  cv::min(images.color, cv::Scalar::all(255), rendering.color);
  return rendering;
}

}  // namespace cvo_slam::synthetic
