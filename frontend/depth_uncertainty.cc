// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include <Eigen/Cholesky>

#include "cvo_slam/frontend/depth_uncertainty_internal.h"

namespace cvo_slam {

Matrix6 depth_covariance(const PointCloud& cloud, double factor) {
  if (cloud.ray_noise.empty() || factor == 0) return Matrix6::Zero();
  Matrix3 along_rays = Matrix3::Zero();
  Matrix3 squares = Matrix3::Zero();  // sum p p^T
  Vector3 points = Vector3::Zero();   // sum p
  double count = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Vector3 p(cloud.x[i], cloud.y[i], cloud.z[i]);
    if (!p.allFinite()) continue;
    const double sigma = factor * static_cast<double>(cloud.ray_noise[i]);
    const double distance2 = p.squaredNorm();
    if (distance2 > 0) along_rays += sigma * sigma / distance2 * p * p.transpose();
    squares += p * p.transpose();
    points += p;
    ++count;
  }
  const Matrix3 cross = skew(points);
  Matrix6 design;  // M
  design << count * Matrix3::Identity(), -cross, cross,
      squares.trace() * Matrix3::Identity() - squares;
  const Matrix6 inverse = design.llt().solve(Matrix6::Identity());
  const auto from_translation = inverse.leftCols<3>();
  return from_translation * along_rays * from_translation.transpose();
}

}  // namespace cvo_slam
