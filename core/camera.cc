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
  if (width <= 0 || height <= 0) {
    throw OptionError(fmt::format("camera: image size {}x{} must be positive", width, height));
  }
  const bool focal_ok = std::isfinite(fx) && std::isfinite(fy) && fx > 0 && fy != 0;
  if (!focal_ok || !std::isfinite(cx) || !std::isfinite(cy)) {
    throw OptionError(
        fmt::format("camera: intrinsics fx={} fy={} cx={} cy={} must be finite, fx > 0, fy != 0",
                    fx, fy, cx, cy));
  }
  if (!std::all_of(distortion.begin(), distortion.end(),
                   [](double k) { return std::isfinite(k); })) {
    throw OptionError("camera: distortion coefficients must be finite");
  }
}

void Camera::check() const {
  color.check();
  if (depth) depth->pinhole.check();
  if (!std::isfinite(depth_scale) || depth_scale <= 0) {
    throw OptionError(fmt::format("camera: depth_scale={} must be positive", depth_scale));
  }
  if (!(readout_time >= 0 && readout_time < 1)) {
    throw OptionError(fmt::format("camera: readout_time={} must be in [0, 1) s", readout_time));
  }
  for (const double deviation : {noise.depth_floor, noise.depth_quadratic, noise.pixel}) {
    if (std::isfinite(deviation) && deviation >= 0) continue;
    throw OptionError(fmt::format("camera: noise={} must be finite and not negative", deviation));
  }
}

}  // namespace cvo_slam
