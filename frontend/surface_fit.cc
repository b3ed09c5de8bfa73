// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <Eigen/Cholesky>

#include "cvo_slam/frontend/kernel_shape_internal.h"
#include "cvo_slam/frontend/surface_fit_internal.h"

namespace cvo_slam {
namespace {

/// Samples on each side of a pixel, in both directions.
constexpr int kSide = 3;
/// Distance of the samples as a share of the focal length: 2 px of a Kinect.
constexpr double kStepOfFocalLength = 0.004;
/// Least share of the samples that must lie on the surface.
constexpr double kMinShare = 0.7;
/// Number of points that tell the noise of a cloud: they are spread over the image.
constexpr std::size_t kNoisePoints = 100;
/// The noise about a plane is smaller than that of a depth on its own, as neighbouring depths have
/// much of their error in common: this share of it with a Kinect.
constexpr double kLocalShare = 0.4;
/// The sums of a least-squares fit of y = c . x, over samples (x, y).
struct PlaneSums {
  Matrix3 xx = Matrix3::Zero();
  Vector3 xy = Vector3::Zero();
  double yy = 0;
  int count = 0;

  void add(const Vector3& x, double y) {
    xx += x * x.transpose();
    xy += y * x;
    yy += y * y;
    ++count;
  }
};

/// Returns the lower quartile of the noise over the squared depth that the first points show;
/// infinity if none lies on a plane. Curved places look noisy, the smoothest quarter does not.
float noise_of(const SurfaceFit& fit, const std::vector<cv::Point>& pixels,
               const PointCloud& cloud) {
  std::array<float, kNoisePoints> noise{};
  std::size_t count = 0;
  for (std::size_t i = 0; i < std::min(kNoisePoints, cloud.size()); ++i) {
    const auto plane = fit.at(pixels[i]);
    if (plane) noise[count++] = static_cast<float>(plane->depth_rms) / (cloud.z[i] * cloud.z[i]);
  }
  if (count == 0) return std::numeric_limits<float>::infinity();
  std::nth_element(noise.begin(), noise.begin() + count / 4, noise.begin() + count);
  return noise[count / 4];
}

}  // namespace

SurfaceFit::SurfaceFit(const cv::Mat& depth, const Camera& camera, const std::vector<float>& rays,
                       double max_depth_step)
    : depth_(depth),
      rays_(rays),
      metres_(1 / camera.depth_scale),
      max_depth_step_(max_depth_step),
      step_(std::max(1, static_cast<int>(std::lround(kStepOfFocalLength * camera.color.fx)))) {}

std::optional<SurfaceFit::Plane> SurfaceFit::at(const cv::Point& pixel) const {
  const auto ray = [&](int u, int v) {
    const std::size_t i = 2 * static_cast<std::size_t>(v * depth_.cols + u);
    return Vector3(rays_[i], rays_[i + 1], 1);
  };
  const double z = metres_ * depth_.at<std::uint16_t>(pixel);
  const Vector3 center = ray(pixel.x, pixel.y);
  PlaneSums sums;
  for (int dv = -kSide; dv <= kSide; ++dv) {
    const int v = pixel.y + dv * step_;
    if (v < 0 || v >= depth_.rows) continue;
    for (int du = -kSide; du <= kSide; ++du) {
      const int u = pixel.x + du * step_;
      if (u < 0 || u >= depth_.cols) continue;
      const double sample = metres_ * depth_.at<std::uint16_t>(v, u);
      if (!(std::abs(sample - z) <= max_depth_step_ * z)) continue;
      const Vector3 offset = ray(u, v) - center;
      sums.add({offset.x(), offset.y(), 1}, 1 / sample - 1 / z);
    }
  }
  constexpr int kSamples = (2 * kSide + 1) * (2 * kSide + 1);
  constexpr int kUnknowns = 3;
  if (sums.count < kMinShare * kSamples) return std::nullopt;
  const Eigen::LDLT<Matrix3> ldlt(sums.xx);
  const Vector3 c = ldlt.solve(sums.xy);
  // 1/z = c0 (x/z - x0) + c1 (y/z - y0) + c2 + 1/z0, so that (c0, c1, C) . p = 1 for the points p.
  const double inverse_depth = c.z() + 1 / z;
  const Vector3 normal(c.x(), c.y(), inverse_depth - c.x() * center.x() - c.y() * center.y());
  const double squared_errors = std::max(0.0, sums.yy - c.dot(sums.xy));
  if (!(inverse_depth > 0) || !(normal.norm() > 0)) return std::nullopt;
  return Plane{normal.normalized(), std::sqrt(squared_errors / (sums.count - kUnknowns)) /
                                        (inverse_depth * inverse_depth)};
}

void fit_surfaces(const SurfaceFit& fit, const std::vector<cv::Point>& pixels,
                  const SE3& T_color_depth, const SensorNoise& noise, PointCloud& cloud) {
  cloud.surface_noise = noise_of(fit, pixels, cloud);
  const double expected = kLocalShare * noise.depth_quadratic;
  const auto share = std::min(1.0F, cloud.surface_noise / static_cast<float>(expected));
  for (float& value : cloud.ray_noise) value *= share;
  cloud.surfaces.clear();
  if (!(static_cast<double>(cloud.surface_noise) < kUselessSurfaceNoise)) return;
  cloud.surfaces.resize(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const auto plane = fit.at(pixels[i]);
    if (!plane) continue;
    const Vector3 normal = T_color_depth.rotation() * plane->normal;
    const Vector3 p = cloud.position(i);
    cloud.surfaces[i] = {normal.cast<float>(),
                         static_cast<float>(plane->depth_rms * std::abs(normal.dot(p)) / p.z())};
  }
}

}  // namespace cvo_slam
