// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "cvo_slam/frontend/kernel_shape_internal.h"

namespace cvo_slam {
namespace {

/// Width of a kernel across a surface without noise, as a share of the length scale.
constexpr double kThinnest = 0.1;
/// Returns the square of the width of a point's kernel across its surface [m^2].
double squared_thickness(const PointCloud& cloud, std::size_t j, double length_scale) {
  const double roughness = cloud.surfaces[j].roughness;
  const double noise =
      length_scale * static_cast<double>(cloud.surface_noise) / kUselessSurfaceNoise;
  const double thinnest = kThinnest * length_scale;
  return std::min(length_scale * length_scale,
                  thinnest * thinnest + roughness * roughness + noise * noise);
}

bool has_surfaces(const PointCloud& cloud, const KernelOptions& kernel) {
  return kernel.surfaces && !cloud.surfaces.empty() &&
         static_cast<double>(cloud.surface_noise) < kUselessSurfaceNoise;
}

bool has_rays(const PointCloud& cloud, const KernelOptions& kernel) {
  return kernel.ray_noise > 0 && !cloud.ray_noise.empty();
}

}  // namespace

bool is_shaped(const PointCloud& cloud, const KernelOptions& kernel) {
  return has_rays(cloud, kernel) || has_surfaces(cloud, kernel);
}

Vector3 kernel_ray(const PointCloud& cloud, std::size_t j, const KernelOptions& kernel,
                   double length_scale) {
  if (!has_rays(cloud, kernel)) return Vector3::Zero();
  const double noise = kernel.ray_noise * static_cast<double>(cloud.ray_noise[j]);
  const Vector3 position = cloud.position(j);
  const double length = position.norm();
  if (!(length > 0 && noise > 0 && std::isfinite(noise))) return Vector3::Zero();
  return position * (noise / (length * std::sqrt(length_scale * length_scale + noise * noise)));
}

Matrix3 kernel_precision(const PointCloud& cloud, std::size_t j, const Matrix3& rotation,
                         const KernelOptions& kernel, double length_scale) {
  const double ell2 = length_scale * length_scale;
  Matrix3 P = Matrix3::Identity();
  if (has_surfaces(cloud, kernel)) {
    const Vector3 normal = rotation * cloud.surfaces[j].normal.cast<double>();
    P += (ell2 / squared_thickness(cloud, j, length_scale) - 1) * normal * normal.transpose();
  }
  const Vector3 a = rotation * kernel_ray(cloud, j, kernel, length_scale);
  const double alpha = a.squaredNorm();
  if (alpha == 0) return P;
  // The precision of the sum of two covariances, one of which is sigma^2 d d^T (Sherman, Morrison),
  // with sigma^2 / ell^2 = alpha / (1 - alpha) and d = a / sqrt(alpha).
  const Vector3 Pa = P * a;
  return P - Pa * Pa.transpose() / (1 - alpha + a.dot(Pa));
}

}  // namespace cvo_slam
