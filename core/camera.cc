// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/core/camera.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "cvo_slam/core/error.h"

namespace cvo_slam {
namespace {

Eigen::Vector2d distort(const std::array<double, 5>& coefficients, Eigen::Vector2d p) {
  apply_brown_distortion(coefficients, p.x(), p.y());
  return p;
}

[[noreturn]] void fail_camera(const std::string& problem) {
  throw OptionError("camera: " + problem);
}

/// Memory is taken for whole images before the first one is seen.
void check_image_size(int width, int height) {
  constexpr int kLongestSide = 16384;
  constexpr double kMostPixels = 8192.0 * 8192.0;
  if (width <= 0 || height <= 0) {
    fail_camera(fmt::format("image size {}x{} must be positive", width, height));
  }
  if (width > kLongestSide || height > kLongestSide ||
      static_cast<double>(width) * height > kMostPixels) {
    fail_camera(
        fmt::format("image size {}x{} is too large; a side has at most {} pixels, and an image {} "
                    "million",
                    width, height, kLongestSide, static_cast<int>(kMostPixels / 1e6)));
  }
}

/// A focal length of a twentieth of the side would be a field of view of 169 degrees, one of 100
/// sides half a degree: such numbers are in other units (mm, image widths), of another image size
/// or in another's place. No pixel is four times as long as it is wide.
void check_focal_length(const char* name, double focal_length, const char* side, int pixels) {
  const double ratio = std::fabs(focal_length) / pixels;
  if (ratio >= 0.05 && ratio <= 100) return;
  fail_camera(fmt::format("{}={} does not fit the {} of {} px; give it in pixels of these images",
                          name, focal_length, side, pixels));
}

void check_intrinsics(const PinholeCamera& camera) {
  const auto& [width, height, fx, fy, cx, cy, distortion] = camera;
  const bool focal_ok = std::isfinite(fx) && std::isfinite(fy) && fx > 0 && fy != 0;
  if (!focal_ok || !std::isfinite(cx) || !std::isfinite(cy)) {
    fail_camera(fmt::format("intrinsics fx={} fy={} cx={} cy={} must be finite, fx > 0, fy != 0",
                            fx, fy, cx, cy));
  }
  check_focal_length("fx", fx, "width", width);
  check_focal_length("fy", fy, "height", height);
  if (fx > 4 * std::fabs(fy) || std::fabs(fy) > 4 * fx) {
    fail_camera(
        fmt::format("fx={} and fy={} differ too much; check their order and values", fx, fy));
  }
  if (camera.contains({cx, cy})) return;
  fail_camera(
      fmt::format("the principal point cx={} cy={} is outside the image of {}x{}; check the order "
                  "fx, fy, cx, cy and the image size",
                  cx, cy, width, height));
}

/// Lenses have |p1| and |p2| below 0.05, and move no point by more than its distance from the
/// centre; ten and two times that is no lens but, for example, a focal length in the wrong place.
void check_lens(const PinholeCamera& camera) {
  const auto& [k1, k2, p1, p2, k3] = camera.distortion;
  if (!std::all_of(camera.distortion.begin(), camera.distortion.end(),
                   [](double k) { return std::isfinite(k); })) {
    fail_camera("distortion coefficients must be finite");
  }
  constexpr double kLargestTangential = 0.5;
  constexpr double kLargestRadial = 2;
  const double x = std::max(camera.cx, camera.width - 1 - camera.cx) / camera.fx;
  const double y = std::max(camera.cy, camera.height - 1 - camera.cy) / camera.fy;
  const double r2 = x * x + y * y;
  const double radial = r2 * (k1 + r2 * (k2 + r2 * k3));
  if (std::fabs(p1) <= kLargestTangential && std::fabs(p2) <= kLargestTangential &&
      std::fabs(radial) <= kLargestRadial) {
    return;
  }
  fail_camera(
      fmt::format("no lens has the distortion k1={} k2={} p1={} p2={} k3={}; check the order (k1, "
                  "k2, p1, p2, k3) and the values",
                  k1, k2, p1, p2, k3));
}

/// A depth image has 16 bits: at less than one unit a metre it would resolve metres only, and at a
/// million it would end after 7 cm.
void check_depth_scale(double depth_scale) {
  if (!std::isfinite(depth_scale) || depth_scale <= 0) {
    fail_camera(fmt::format("depth_scale={} must be positive", depth_scale));
  }
  if (depth_scale < 1) {
    fail_camera(
        fmt::format("depth_scale={} is less than 1; it is in units of the depth image per "
                    "metre, for example 1000 for millimetres",
                    depth_scale));
  }
  if (depth_scale > 1e6) {
    fail_camera(
        fmt::format("depth_scale={} is more than 1e6; it is in units of the depth image "
                    "per metre, for example 5000 for TUM",
                    depth_scale));
  }
}

/// The two cameras are in one housing.
void check_baseline(const SE3& T_color_depth) {
  const double baseline = T_color_depth.translation().norm();
  if (baseline <= 2) return;
  fail_camera(
      fmt::format("T_color_depth moves the depth camera by {:.6g} m; the translation is in "
                  "metres, not in millimetres",
                  baseline));
}

void check_noise(const SensorNoise& noise) {
  for (const double deviation : {noise.depth_floor, noise.depth_quadratic, noise.pixel}) {
    if (std::isfinite(deviation) && deviation >= 0) continue;
    fail_camera(fmt::format("noise={} must be finite and not negative", deviation));
  }
}

}  // namespace

bool PinholeCamera::has_distortion() const {
  return std::any_of(distortion.begin(), distortion.end(), [](double k) { return k != 0; });
}

Eigen::Vector2d PinholeCamera::project(const Vector3& point) const {
  Eigen::Vector2d normalized(point.x() / point.z(), point.y() / point.z());
  if (has_distortion()) normalized = distort(distortion, normalized);
  return {fx * normalized.x() + cx, fy * normalized.y() + cy};
}

Vector3 PinholeCamera::unproject(const Eigen::Vector2d& pixel) const {
  const Eigen::Vector2d observed((pixel.x() - cx) / fx, (pixel.y() - cy) / fy);
  Eigen::Vector2d undistorted = observed;
  if (has_distortion()) {
    // Converges if the model is monotone, which a usable calibration is inside its image.
    constexpr int kIterations = 50;
    constexpr double kTolerance = 1e-10;
    for (int i = 0; i < kIterations; ++i) {
      const Eigen::Vector2d error = distort(distortion, undistorted) - observed;
      undistorted -= error;
      if (error.squaredNorm() < kTolerance * kTolerance) break;
    }
  }
  return {undistorted.x(), undistorted.y(), 1.0};
}

bool PinholeCamera::contains(const Eigen::Vector2d& pixel) const {
  return pixel.x() >= -0.5 && pixel.y() >= -0.5 && pixel.x() < width - 0.5 &&
         pixel.y() < height - 0.5;
}

void PinholeCamera::check() const {
  check_image_size(width, height);
  check_intrinsics(*this);
  check_lens(*this);
}

void Camera::check() const {
  color.check();
  if (depth) {
    depth->pinhole.check();
    check_baseline(depth->T_color_depth);
  }
  check_depth_scale(depth_scale);
  if (!(std::fabs(depth_offset.value_or(0)) <= 1e6)) {
    fail_camera(fmt::format("depth_offset={} must be at most a million seconds", *depth_offset));
  }
  if (!(readout_time >= 0 && readout_time < 1)) {
    fail_camera(fmt::format("readout_time={} must be in [0, 1) s", readout_time));
  }
  check_noise(noise);
}

bool is_same_camera(const Camera& a, const Camera& b) {
  const auto is_same = [](const PinholeCamera& c, const PinholeCamera& d) {
    return c.width == d.width && c.height == d.height && c.fx == d.fx && c.fy == d.fy &&
           c.cx == d.cx && c.cy == d.cy && c.distortion == d.distortion;
  };
  return is_same(a.color, b.color) && a.depth_scale == b.depth_scale;
}

}  // namespace cvo_slam
