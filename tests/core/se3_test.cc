// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/core/se3.h"

#include <cmath>
#include <numbers>
#include <random>

#include <Eigen/LU>
#include <gtest/gtest.h>

namespace cvo_slam {
namespace {

/// Seeded random tangents over all magnitudes that matter: tiny, at the series' border, generic,
/// and close to a half turn.
std::vector<Vector6> sample_tangents() {
  std::mt19937 rng(7);
  std::normal_distribution<double> normal;
  std::vector<Vector6> samples = {Vector6::Zero()};
  for (const double angle : {1e-12, 1e-8, 1e-4, 0.099999, 0.100001, 0.7, 2.0, 3.1, 3.1415}) {
    for (int i = 0; i < 5; ++i) {
      Vector6 xi;
      for (int k = 0; k < 6; ++k) xi[k] = normal(rng);
      xi.tail<3>() *= angle / xi.tail<3>().norm();
      samples.push_back(xi);
    }
  }
  return samples;
}

double distance(const SE3& a, const SE3& b) { return (a.matrix() - b.matrix()).norm(); }

TEST(Se3, LayoutDoesNotDependOnVectorInstructions) {
  EXPECT_EQ(alignof(SE3), alignof(double));
  EXPECT_EQ(alignof(Matrix6), alignof(double));
}

TEST(Se3, GroupAxioms) {
  const auto samples = sample_tangents();
  for (std::size_t i = 0; i + 2 < samples.size(); ++i) {
    const SE3 a = SE3::exp(samples[i]);
    const SE3 b = SE3::exp(samples[i + 1]);
    const SE3 c = SE3::exp(samples[i + 2]);
    EXPECT_LT(distance((a * b) * c, a * (b * c)), 1e-13);
    EXPECT_LT(distance(a * SE3(), a), 1e-15);
    EXPECT_LT(distance(a * a.inverse(), SE3()), 1e-13);
  }
}

TEST(Se3, ExpSolvesItsDifferentialEquation) {
  // exp(xi) = (exp(xi / 2^k))^(2^k), with the inner exponential from its plain power series.
  for (const Vector6& xi : sample_tangents()) {
    Eigen::Matrix4d generator = Eigen::Matrix4d::Zero();
    generator.topLeftCorner<3, 3>() = skew(xi.tail<3>());
    generator.topRightCorner<3, 1>() = xi.head<3>();
    constexpr int kHalvings = 8;
    const Eigen::Matrix4d small = generator / std::pow(2.0, kHalvings);
    Eigen::Matrix4d power = Eigen::Matrix4d::Identity();
    Eigen::Matrix4d sum = power;
    for (int k = 1; k < 12; ++k) {
      power = power * small / k;
      sum += power;
    }
    for (int k = 0; k < kHalvings; ++k) sum = (sum * sum).eval();
    EXPECT_LT((SE3::exp(xi).matrix() - sum).norm(), 1e-12) << xi.transpose();
  }
}

TEST(Se3, LogInvertsExp) {
  for (const Vector6& xi : sample_tangents()) {
    const double tolerance = xi.tail<3>().norm() > 3.1 ? 1e-9 : 1e-12;  // log is steep near pi
    EXPECT_LT((SE3::exp(xi).log() - xi).norm(), tolerance) << xi.transpose();
  }
}

TEST(Se3, LogOfAHalfTurnHasLengthPi) {
  for (const Vector3& axis : {Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1),
                              Vector3(1, -2, 0.5).normalized().eval()}) {
    const Matrix3 half_turn = 2 * axis * axis.transpose() - Matrix3::Identity();
    EXPECT_NEAR(so3_log(half_turn).norm(), std::numbers::pi, 1e-12);
    EXPECT_LT((so3_exp(so3_log(half_turn)) - half_turn).norm(), 1e-12);
  }
}

TEST(Se3, AdjointMovesAPerturbationAcross) {
  const Vector6 xi = (Vector6() << 0.3, -0.2, 0.1, 0.2, 0.4, -0.3).finished();
  for (const Vector6& sample : sample_tangents()) {
    const SE3 T = SE3::exp(sample);
    EXPECT_LT(distance(T * SE3::exp(xi) * T.inverse(), SE3::exp(T.adjoint() * xi)), 1e-12);
  }
}

TEST(Se3, InterpolationFollowsTheGeodesic) {
  const SE3 a = SE3::exp((Vector6() << 1, 2, 3, 0.1, 0.2, 0.3).finished());
  const SE3 b = SE3::exp((Vector6() << 0, 2, 4, -0.3, 0.5, 1.0).finished());
  EXPECT_LT(distance(interpolate(a, b, 0), a), 1e-13);
  EXPECT_LT(distance(interpolate(a, b, 1), b), 1e-13);
  const SE3 middle = interpolate(a, b, 0.5);
  EXPECT_LT(distance(middle * (a.inverse() * middle), b), 1e-13);
}

TEST(Se3, FromMatrixRoundsToTheNearestRotation) {
  const SE3 T = SE3::exp((Vector6() << 1, 2, 3, 0.1, 0.2, 0.3).finished());
  Eigen::Matrix4d noisy = T.matrix();
  noisy.topLeftCorner<3, 3>() *= 1.001;  // a pure scale leaves the nearest rotation unchanged
  EXPECT_LT(distance(SE3::from_matrix(noisy), T), 1e-12);
  noisy.topLeftCorner<3, 3>().col(0) *= -1;  // never a reflection
  EXPECT_NEAR(SE3::from_matrix(noisy).rotation().determinant(), 1.0, 1e-12);
}

TEST(Se3, QuaternionRoundTrip) {
  for (const Vector6& xi : sample_tangents()) {
    const SE3 T = SE3::exp(xi);
    const Eigen::Vector4d q = T.quaternion();
    EXPECT_GE(q[3], 0.0);
    EXPECT_LT(distance(SE3::from_quaternion(q[0], q[1], q[2], q[3], T.translation()), T), 1e-14);
    EXPECT_LT(
        distance(SE3::from_quaternion(-3 * q[0], -3 * q[1], -3 * q[2], -3 * q[3], T.translation()),
                 T),
        1e-14);
  }
}

}  // namespace
}  // namespace cvo_slam
