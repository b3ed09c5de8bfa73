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

// What the compiler vectorises without SSE4.
int floor_of(float value) {
  const int towards_zero = static_cast<int>(value);
  return towards_zero - static_cast<int>(static_cast<float>(towards_zero) > value);
}
int ceil_of(float value) {
  const int towards_zero = static_cast<int>(value);
  return towards_zero + static_cast<int>(static_cast<float>(towards_zero) < value);
}
int round_of(float value) {
  constexpr float kIntegers = 1 << 23;  // from here on a float has no other values
  return static_cast<int>((value + kIntegers) - kIntegers);
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

/// The pixels of one row of the depth image, projected into the colour camera.
struct DepthRegistration::ProjectedRow {
  explicit ProjectedRow(std::size_t width) : u(width), v(width), z(width), scale(width) {}
  std::vector<float> u, v;   // [px]
  std::vector<float> z;      // in units of the depth image; kNothing = none or not visible
  std::vector<float> scale;  // depth in the depth camera / z
};

/// What they cover there: the first and the last pixels, and the depth.
struct DepthRegistration::Footprints {
  explicit Footprints(std::size_t width)
      : left(width), right(width), top(width), bottom(width), depth(width) {}
  std::vector<int> left, right, top, bottom;
  std::vector<std::uint16_t> depth;  // kNothing if nothing is covered
};

void DepthRegistration::project_row(const std::uint16_t* depth, int depth_row,
                                    ProjectedRow& row) const {
  // On local copies and without branches on the pixels: the processor works on several at once.
  const auto width = static_cast<std::size_t>(width_);
  const std::size_t first = static_cast<std::size_t>(depth_row) * width;
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
    const float u = k[0] * x + k[2];
    const float v = k[1] * y + k[3];
    const float scale = units * inverse_z;
    row.u[i] = visible ? u : 0;
    row.v[i] = visible ? v : 0;
    row.z[i] = visible ? z : kNothing;
    row.scale[i] = visible ? scale : 0;
  }
}

void DepthRegistration::find_footprints(const ProjectedRow& row, Footprints& footprints) const {
  // The compiler vectorises this loop.
  const std::size_t width = row.z.size();
  const float* row_u = row.u.data();
  const float* row_v = row.v.data();
  const float* row_z = row.z.data();
  const float* row_scale = row.scale.data();
  int* row_left = footprints.left.data();
  int* row_right = footprints.right.data();
  int* row_top = footprints.top.data();
  int* row_bottom = footprints.bottom.data();
  std::uint16_t* row_depth = footprints.depth.data();
  const float half_u = half_u_;
  const float half_v = half_v_;
  const int last_u = color_.width - 1;
  const int last_v = color_.height - 1;
  for (std::size_t i = 0; i < width; ++i) {
    const int left = std::max(0, ceil_of(row_u[i] - half_u * row_scale[i]));
    const int top = std::max(0, ceil_of(row_v[i] - half_v * row_scale[i]));
    const int right = std::min(last_u, floor_of(row_u[i] + half_u * row_scale[i]));
    const int bottom = std::min(last_v, floor_of(row_v[i] + half_v * row_scale[i]));
    const int depth = round_of(row_z[i]);
    row_left[i] = left;
    row_right[i] = right;
    row_top[i] = top;
    row_bottom[i] = bottom;
    // NOLINTNEXTLINE(readability-implicit-bool-conversion): no branches
    const int covers = (left <= right) & (top <= bottom);
    row_depth[i] = static_cast<std::uint16_t>(covers != 0 ? depth : kNothing);
  }
}

void DepthRegistration::fill(const Footprints& footprints, cv::Mat& image) {
  const auto& [left, right, top, bottom, depth] = footprints;
  auto* pixels = image.ptr<std::uint16_t>();
  const std::size_t stride = image.step1();
  const auto take_nearest = [&](int v, int u, std::uint16_t value) {
    auto& pixel = pixels[static_cast<std::size_t>(v) * stride + static_cast<std::size_t>(u)];
    pixel = std::min(pixel, value);
  };
  for (std::size_t i = 0; i < depth.size(); ++i) {
    if (depth[i] == kNothing) continue;
    if (right[i] - left[i] > 1 || bottom[i] - top[i] > 1) {
      for (int v = top[i]; v <= bottom[i]; ++v) {
        for (int u = left[i]; u <= right[i]; ++u) take_nearest(v, u, depth[i]);
      }
      continue;
    }
    // Where the cameras have about the same resolution: up to 2x2 pixels, some of them twice, which
    // costs less than to branch.
    take_nearest(top[i], left[i], depth[i]);
    take_nearest(top[i], right[i], depth[i]);
    take_nearest(bottom[i], left[i], depth[i]);
    take_nearest(bottom[i], right[i], depth[i]);
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
  Footprints footprints(static_cast<std::size_t>(width_));
  for (int v = 0; v < height_; ++v) {
    project_row(depth.ptr<std::uint16_t>(v), v, row);
    find_footprints(row, footprints);
    fill(footprints, result);
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
