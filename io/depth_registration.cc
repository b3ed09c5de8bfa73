// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/io/depth_registration.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <opencv2/core.hpp>

#include "cvo_slam/core/error.h"

namespace cvo_slam {
namespace {

/// Neighbouring footprints overlap by this factor: surfaces that turn away from the depth camera,
/// and the rounding of stereo depth, tear them apart by a part of a pixel.
constexpr double kFootprintOverlap = 1.3;

/// The largest (x/z)^2 + (y/z)^2 of the rays through the border of the image.
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

/// Half the extent, along u and v of the colour image, of a pixel of the depth image.
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
  if (!camera.depth) throw OptionError("camera: depth registration needs a depth camera");
  const DepthCamera& depth = *camera.depth;
  width_ = depth.pinhole.width;
  height_ = depth.pinhole.height;
  color_is_distorted_ = color_.has_distortion();
  focal_ = Eigen::Vector2d(color_.fx, color_.fy).cast<float>();
  center_ = Eigen::Vector2d(color_.cx, color_.cy).cast<float>();
  max_radius2_ = static_cast<float>(largest_radius2(color_));
  half_size_ = half_footprint(color_, depth);
  translation_ = (camera.depth_scale * depth.T_color_depth.translation()).cast<float>();
  rays_.reserve(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  for (int v = 0; v < height_; ++v) {
    for (int u = 0; u < width_; ++u) {
      const Vector3 ray = depth.T_color_depth.rotation() * depth.pinhole.unproject({u, v});
      rays_.emplace_back(ray.cast<float>());
    }
  }
}

Eigen::Vector2f DepthRegistration::project(const Eigen::Vector3f& point) const {
  if (color_is_distorted_) return color_.project(point.cast<double>()).cast<float>();
  return {focal_.x() * point.x() / point.z() + center_.x(),
          focal_.y() * point.y() / point.z() + center_.y()};
}

void DepthRegistration::splat(const Eigen::Vector2f& pixel, const Eigen::Vector2f& half_size,
                              std::uint16_t depth, cv::Mat& image) {
  const int u_begin = std::max(0, cvCeil(pixel.x() - half_size.x()));
  const int u_end = std::min(image.cols - 1, cvFloor(pixel.x() + half_size.x()));
  const int v_begin = std::max(0, cvCeil(pixel.y() - half_size.y()));
  const int v_end = std::min(image.rows - 1, cvFloor(pixel.y() + half_size.y()));
  for (int v = v_begin; v <= v_end; ++v) {
    auto* row = image.ptr<std::uint16_t>(v);
    for (int u = u_begin; u <= u_end; ++u) row[u] = std::min(row[u], depth);
  }
}

cv::Mat DepthRegistration::to_color(const cv::Mat& depth) const {
  if (depth.type() != CV_16UC1 || depth.cols != width_ || depth.rows != height_) {
    throw Error("depth registration: the image is not of the depth camera's size and 16 bits");
  }
  constexpr auto kNothing = std::numeric_limits<std::uint16_t>::max();
  cv::Mat result(color_.height, color_.width, CV_16UC1, cv::Scalar(kNothing));
  const Eigen::Vector3f* ray = rays_.data();
  for (int v = 0; v < height_; ++v) {
    const auto* row = depth.ptr<std::uint16_t>(v);
    for (int u = 0; u < width_; ++u, ++ray) {
      if (row[u] == 0) continue;
      const auto units = static_cast<float>(row[u]);
      const Eigen::Vector3f point = units * *ray + translation_;
      const float z = point.z();
      const bool visible =
          z >= 1 && z < kNothing - 1 && point.head<2>().squaredNorm() <= max_radius2_ * z * z;
      if (!visible) continue;
      splat(project(point), half_size_ * (units / z), static_cast<std::uint16_t>(z + 0.5F), result);
    }
  }
  result.setTo(0, result == kNothing);
  return result;
}

}  // namespace cvo_slam
