// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <limits>
#include <random>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "cvo_slam/frontend/depth_uncertainty_internal.h"

namespace cvo_slam {
namespace {

/// Adds a point with a depth noise of z^2 / 200.
void add(PointCloud& cloud, const Vector3& p) {
  cloud.x.push_back(static_cast<float>(p.x()));
  cloud.y.push_back(static_cast<float>(p.y()));
  cloud.z.push_back(static_cast<float>(p.z()));
  cloud.ray_noise.push_back(static_cast<float>(0.005 * p.z() * p.norm()));
}

Vector3 point(const PointCloud& cloud, std::size_t i) {
  return {cloud.x[i], cloud.y[i], cloud.z[i]};
}

/// Points in the view of a camera, `near` to `near` + 2 m away.
PointCloud view(std::size_t count, double near) {
  std::mt19937_64 random(4);
  const auto uniform = [&random] { return static_cast<double>(random() >> 11U) * 0x1.0p-53; };
  PointCloud cloud;
  for (std::size_t i = 0; i < count; ++i) {
    const double z = near + 2 * uniform();
    add(cloud, {z * (uniform() - 0.5), z * (uniform() - 0.5), z});
  }
  return cloud;
}

TEST(DepthCovariance, IsThatOfLeastSquaresPosesOfPointsMovedAlongTheirRays) {
  constexpr double kNoise = 0.005;
  const PointCloud cloud = view(60, 1.5);
  Eigen::Matrix<double, 6, 6> design = Eigen::Matrix<double, 6, 6>::Zero();
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    Eigen::Matrix<double, 3, 6> J;
    J << Matrix3::Identity(), -skew(point(cloud, i));
    design += J.transpose() * J;
  }
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  constexpr int kTrials = 20000;
  Eigen::Matrix<double, 6, 6> sampled = Eigen::Matrix<double, 6, 6>::Zero();
  for (int trial = 0; trial < kTrials; ++trial) {
    Eigen::Matrix<double, 6, 1> right = Eigen::Matrix<double, 6, 1>::Zero();
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const Vector3 p = point(cloud, i);
      const Vector3 moved = kNoise * p.z() * p.z() * normal(random) * p / p.z();
      right.head<3>() += moved;
      right.tail<3>() += p.cross(moved);
    }
    const Eigen::Matrix<double, 6, 1> pose = design.llt().solve(right);
    sampled += pose * pose.transpose() / kTrials;
  }
  const Matrix6 expected = depth_covariance(cloud, 1);
  EXPECT_LT((expected - sampled).norm(), 0.04 * expected.norm());
}

TEST(DepthCovariance, GrowsWithDistanceAndIsNothingWithoutNoise) {
  EXPECT_GT(depth_covariance(view(60, 4), 1)(2, 2), 4 * depth_covariance(view(60, 1), 1)(2, 2));
  EXPECT_EQ(depth_covariance(view(60, 1), 0), Matrix6(Matrix6::Zero()));
  PointCloud of_unknown_noise = view(60, 1);
  of_unknown_noise.ray_noise.clear();
  EXPECT_EQ(depth_covariance(of_unknown_noise, 1), Matrix6(Matrix6::Zero()));
}

TEST(DepthCovariance, OfAPointInTheCameraIsFinite) {
  PointCloud cloud = view(60, 1);
  add(cloud, Vector3::Zero());
  EXPECT_TRUE(depth_covariance(cloud, 1).allFinite());
}

TEST(DepthCovariance, LeavesOutPointsWithoutDepth) {
  PointCloud cloud = view(60, 1);
  const Matrix6 expected = depth_covariance(cloud, 1);
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  add(cloud, {kNone, kNone, kNone});
  EXPECT_EQ(depth_covariance(cloud, 1), expected);
}

}  // namespace
}  // namespace cvo_slam
