// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/io/depth_registration.h"

#include <algorithm>
#include <limits>

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/error.h"
#include "cvo_slam/io/image_files_internal.h"

namespace cvo_slam {
namespace {

/// Footprints are larger than the distance between them by this factor: slanted surfaces and the
/// rounding of stereo depth move neighbours apart by a fraction of a pixel.
constexpr double kFootprintOverlap = 1.3;

/// Value of an empty pixel of the z-buffer, and the largest depth, which rounds to less.
constexpr auto kNothing = std::numeric_limits<std::uint16_t>::max();
constexpr float kFarthestUnits = kNothing - 1;

std::array<float, 5> to_float(const std::array<double, 5>& values) {
  std::array<float, 5> result{};
  std::transform(values.begin(), values.end(), result.begin(),
                 [](double value) { return static_cast<float>(value); });
  return result;
}

/// Returns the largest (x/z)^2 + (y/z)^2 of the rays through the border of the image.
double largest_radius2(const PinholeCamera& camera) {
  double largest = 0;
  const auto add = [&](double u, double v) {
    largest = std::max(largest, camera.unproject({u, v}).head<2>().squaredNorm());
  };
  for (int u = 0; u < camera.width; ++u) {
    add(u, -0.5);
    add(u, camera.height - 0.5);
  }
  for (int v = 0; v < camera.height; ++v) {
    add(-0.5, v);
    add(camera.width - 0.5, v);
  }
  return largest;
}

/// Returns half the size, along u and v of the colour image, of a pixel of the depth image [px].
Eigen::Vector2f half_footprint(const PinholeCamera& color, const DepthCamera& depth) {
  const Eigen::Matrix2d pixel_to_pixel =
      Eigen::Vector2d(color.fx, color.fy).asDiagonal() *
      depth.T_color_depth.rotation().topLeftCorner<2, 2>() *
      Eigen::Vector2d(1 / depth.pinhole.fx, 1 / depth.pinhole.fy).asDiagonal();
  const Eigen::Vector2d half = 0.5 * kFootprintOverlap * pixel_to_pixel.cwiseAbs().rowwise().sum();
  return half.cast<float>();
}

}  // namespace

DepthRegistration::DepthRegistration(const Camera& camera) : color_(camera.color) {
  camera.check();
  if (!camera.depth)
    throw OptionError("camera: depth registration needs a depth camera (key depth)");
  const DepthCamera& depth = *camera.depth;
  width_ = depth.pinhole.width;
  height_ = depth.pinhole.height;
  const Eigen::Vector2f half = half_footprint(color_, depth);
  half_u_ = half.x();
  half_v_ = half.y();
  max_radius2_ = static_cast<float>(largest_radius2(color_));
  const Vector3 translation = camera.depth_scale * depth.T_color_depth.translation();
  Eigen::Vector3f::Map(translation_.data()) = translation.cast<float>();
  for (int v = 0; v < height_; ++v) {
    for (int u = 0; u < width_; ++u) {
      const Vector3 ray = depth.T_color_depth.rotation() * depth.pinhole.unproject({u, v});
      ray_x_.push_back(static_cast<float>(ray.x()));
      ray_y_.push_back(static_cast<float>(ray.y()));
      ray_z_.push_back(static_cast<float>(ray.z()));
    }
  }
}

void DepthRegistration::project_row(const std::uint16_t* depth, int v, ProjectedRow& row) const {
  // On local copies and without branches on the pixels, so that the compiler vectorises the loop.
  const auto width = static_cast<std::size_t>(width_);
  const std::size_t first = static_cast<std::size_t>(v) * width;
  const float* ray_x = ray_x_.data() + first;
  const float* ray_y = ray_y_.data() + first;
  const float* ray_z = ray_z_.data() + first;
  const auto [tx, ty, tz] = translation_;
  const Eigen::Vector4f k =
      Eigen::Vector4d(color_.fx, color_.fy, color_.cx, color_.cy).cast<float>();
  const auto distortion = to_float(color_.distortion);
  const bool is_distorted = color_.has_distortion();
  for (std::size_t i = 0; i < width; ++i) {
    const auto units = static_cast<float>(depth[i]);
    const float z = units * ray_z[i] + tz;
    const float inverse_z = 1 / z;
    float x = (units * ray_x[i] + tx) * inverse_z;
    float y = (units * ray_y[i] + ty) * inverse_z;
    // NOLINTBEGIN(readability-implicit-bool-conversion)
    const bool visible =
        (units > 0) & (z >= 1) & (z < kFarthestUnits) & (x * x + y * y <= max_radius2_);
    // NOLINTEND(readability-implicit-bool-conversion)
    if (is_distorted) apply_brown_distortion(distortion, x, y);
    row.u[i] = k[0] * x + k[2];
    row.v[i] = k[1] * y + k[3];
    row.z[i] = visible ? z : 0;
    row.scale[i] = units * inverse_z;
  }
}

void DepthRegistration::splat_row(const ProjectedRow& row, cv::Mat& image) const {
  for (std::size_t i = 0; i < row.z.size(); ++i) {
    if (row.z[i] == 0) continue;
    const float half_u = half_u_ * row.scale[i];
    const float half_v = half_v_ * row.scale[i];
    const auto depth = static_cast<std::uint16_t>(cvRound(row.z[i]));
    const int u_begin = std::max(0, cvCeil(row.u[i] - half_u));
    const int u_end = std::min(image.cols - 1, cvFloor(row.u[i] + half_u));
    const int v_begin = std::max(0, cvCeil(row.v[i] - half_v));
    const int v_end = std::min(image.rows - 1, cvFloor(row.v[i] + half_v));
    for (int v = v_begin; v <= v_end; ++v) {
      auto* pixels = image.ptr<std::uint16_t>(v);
      for (int u = u_begin; u <= u_end; ++u) pixels[u] = std::min(pixels[u], depth);
    }
  }
}

cv::Mat DepthRegistration::register_depth(const cv::Mat& depth) const {
  if (depth.type() != CV_16UC1 || depth.cols != width_ || depth.rows != height_) {
    throw Error(
        "depth registration: the image must have the size of the depth camera, 16 bits and 1 "
        "channel");
  }
  cv::Mat result(color_.height, color_.width, CV_16UC1, cv::Scalar(kNothing));
  ProjectedRow row(static_cast<std::size_t>(width_));
  for (int v = 0; v < height_; ++v) {
    project_row(depth.ptr<std::uint16_t>(v), v, row);
    splat_row(row, result);
  }
  result.setTo(0, result == kNothing);
  return result;
}

RgbdFrame read_rgbd_images(const std::filesystem::path& color, const std::filesystem::path& depth,
                           const Camera& camera) {
  camera.check();
  return FrameReader(camera).read(color, depth);
}

}  // namespace cvo_slam
