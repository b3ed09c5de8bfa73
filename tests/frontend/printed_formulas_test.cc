// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// These tests decide where the CVO paper (Ghaffari et al., RSS 2019) contradicts itself or the
// derivation in docs/theory/cvo.md. The tests of single coefficients are in gradient_flow_test.cc.
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "cvo_slam/frontend/solvers_internal.h"
#include "cvo_slam/tests/frontend/reference_align.h"
#include "cvo_slam/tests/frontend/test_clouds.h"

namespace cvo_slam {
namespace {

constexpr double kScale = 0.3;

KernelOptions smooth_kernel() {
  KernelOptions kernel;
  kernel.sparsification = 1e-9;
  kernel.color_kernel = ColorKernel::kLinear;
  return kernel;
}

TEST(PrintedAction, TheFormulasMoveByTheInverse) {
  // F(h) = sum c k(x, h^-1 z): for points moved by M the maximum is at h = M, not at M^-1.
  const PointCloud fixed = random_cloud(60, 1);
  const SE3 M = motion(0.2, -0.1, 0.1, 0.1, 0.3, -0.2);
  const PointCloud moving = transformed(fixed, M);
  const double maximum = reference_objective(fixed, fixed, SE3(), smooth_kernel(), kScale);
  const auto f = [&](const SE3& h) {
    return reference_objective(fixed, moving, h.inverse(), smooth_kernel(), kScale);
  };
  EXPECT_NEAR(f(M), maximum, 1e-5 * maximum);  // positions are single precision
  EXPECT_LT(f(M.inverse()), 0.9 * maximum);
}

TEST(PrintedAction, AStepOfHIsAStepBackOfT) {
  // T = h^-1 and h <- h exp(t xi): T <- exp(-t xi) T.
  const Vector6 xi = (Vector6() << 0.1, -0.2, 0.3, 0.2, 0.1, -0.3).finished();
  const SE3 h = motion(0.2, -0.1, 0.1, 0.1, 0.3, -0.2);
  constexpr double kTime = 0.7;
  const SE3 by_h = (h * SE3::exp(kTime * xi)).inverse();
  const SE3 by_T = SE3::exp(-kTime * xi) * h.inverse();
  EXPECT_LT((by_h.matrix() - by_T.matrix()).norm(), 1e-14);
}

/// The factors a_k of a series z + sum a_k t^k w^(k-1) u for the path of a point under the flow.
using SeriesFactors = std::array<double, 4>;

class PrintedSeries : public testing::Test {
 protected:
  /// Moves a point along the series.
  [[nodiscard]] Vector3 moved(const Vector3& z, double t, const SeriesFactors& factors) const {
    Vector3 power = omega_.cross(z) + v_;  // w^(k-1) u
    Vector3 place = z;
    double time = 1;
    for (const double factor : factors) {
      time *= t;
      place += factor * time * power;
      power = omega_.cross(power);
    }
    return place;
  }

  /// Returns G(t) with the points moved by the series.
  [[nodiscard]] double g(double t, const SeriesFactors& factors) const {
    const KernelOptions kernel = smooth_kernel();
    double sum = 0;
    for (std::size_t j = 0; j < moving_.size(); ++j) {
      const Vector3 z = T_ * moving_.position(j);
      const Vector3 place = moved(z, t, factors);
      for (std::size_t i = 0; i < fixed_.size(); ++i) {
        const auto k = [&](const Vector3& p) {
          return std::exp(-(fixed_.position(i) - p).squaredNorm() / (2 * kScale * kScale));
        };
        sum += label_product(kernel, fixed_, i, moving_, j) * (k(place) - k(z));
      }
    }
    return kernel.sigma * kernel.sigma * sum;
  }

  [[nodiscard]] double exact(double t) const {
    Vector6 tangent;
    tangent << -t * v_, -t * omega_;
    const KernelOptions kernel = smooth_kernel();
    return reference_objective(fixed_, moving_, SE3::exp(tangent) * T_, kernel, kScale) -
           reference_objective(fixed_, moving_, T_, kernel, kScale);
  }

  /// Returns the relative error of the curve with these factors at a time that moves points by a
  /// tenth of a length scale.
  [[nodiscard]] double miss(const SeriesFactors& factors) const {
    constexpr double kTime = 0.3;
    return std::abs(g(kTime, factors) / exact(kTime) - 1);
  }

  PointCloud fixed_ = random_cloud(40, 1);
  PointCloud moving_ = random_cloud(30, 2);
  SE3 T_ = motion(0.05, -0.03, 0.02, 0.1, -0.05, 0.2);
  Vector3 omega_{0.5, -0.4, 0.3};
  Vector3 v_{-0.05, 0.07, 0.03};
};

TEST_F(PrintedSeries, WithFactorialsAndAlternatingSignsIsTheMotion) {
  // The fifth order is left: (0.3 |omega|)^5 / 5! = 3e-6 of a metre.
  EXPECT_LT(miss({-1, 1.0 / 2, -1.0 / 6, 1.0 / 24}), 1e-4);
}

TEST_F(PrintedSeries, WithoutFactorialsOrSignsOrBothIsAnotherMotion) {
  EXPECT_GT(miss({-1, 1, -1, 1}), 1e-2);
  EXPECT_GT(miss({-1, -1.0 / 2, -1.0 / 6, -1.0 / 24}), 1e-2);
  EXPECT_GT(miss({-1, -1, -1, -1}), 1e-2);
}

TEST(PrintedTime, StepLimitsAreThoseOfAFlowWithoutTheLengthScale) {
  // The authors' cap of 0.8 belongs to a flow without 1 / ell^2. A step that reaches a cap moves by
  // the cap times that flow.
  const PointCloud fixed = random_cloud(40, 1);
  const PointCloud moving = random_cloud(30, 2);
  Objective level;
  level.build(fixed, smooth_kernel(), kScale);
  const Executor executor;
  PairTable pairs;
  PoseObjective objective(level, moving, moving.size(), pairs, executor);
  FlowConstants options;
  options.max_step = 1e-4;  // far below the step that the expansion chooses
  options.min_step = 0;
  const FlowDirection flow =
      flow_direction(objective.evaluate(SE3()), options.metric_a2, options.metric_b2);
  const Vector6 step = gradient_flow(objective, SE3(), 1, options).T_fixed_moving.log();
  Vector6 expected;
  expected << -flow.v, -flow.omega;
  expected *= options.max_step * kScale * kScale;
  EXPECT_LT((step - expected).norm(), 1e-5 * expected.norm());
}

/// The flow on SE(n), for the metric a^2/2 tr(W1^T W2) + b^2 <v1, v2> on (skew W, v).
class FlowInDimension : public testing::TestWithParam<int> {
 protected:
  using Matrix = Eigen::MatrixXd;
  using Vector = Eigen::VectorXd;

  FlowInDimension() {
    std::mt19937 rng(7);
    std::uniform_real_distribution<double> unit(-0.5, 0.5);
    const auto random = [&] {
      return Vector(Vector::NullaryExpr(GetParam(), [&] { return unit(rng); }));
    };
    for (int i = 0; i < 12; ++i) x_.push_back(random());
    for (int j = 0; j < 9; ++j) z_.push_back(random());
    W_ = Matrix::NullaryExpr(GetParam(), GetParam(), [&] { return unit(rng); });
    W_ = (W_ - W_.transpose()).eval();
    v_ = random();
  }

  static double k(const Vector& x, const Vector& z) {
    return std::exp(-(x - z).squaredNorm() / (2 * kScale * kScale));
  }

  /// Returns sum k(x, exp(-t xi) z) to second order in t.
  [[nodiscard]] double f(double t) const {
    double sum = 0;
    for (const Vector& z : z_) {
      const Vector u = W_ * z + v_;
      const Vector place = z - t * u + t * t / 2 * (W_ * u);
      for (const Vector& x : x_) sum += k(x, place);
    }
    return sum;
  }

  std::vector<Vector> x_;
  std::vector<Vector> z_;
  Matrix W_;  ///< a direction
  Vector v_;
};

TEST_P(FlowInDimension, IsTheGradientForHalfTheTrace) {
  constexpr double kA2 = 7;
  constexpr double kB2 = 5;
  constexpr double kInv2 = 1 / (kScale * kScale);
  Matrix W_flow = Matrix::Zero(GetParam(), GetParam());
  Vector v_flow = Vector::Zero(GetParam());
  for (const Vector& x : x_) {
    for (const Vector& z : z_) {
      W_flow += kInv2 / kA2 * k(x, z) * (z * x.transpose() - x * z.transpose());
      v_flow += kInv2 / kB2 * k(x, z) * (z - x);
    }
  }
  constexpr double kStep = 1e-4;
  const double slope = (f(kStep) - f(-kStep)) / (2 * kStep);
  const double turning = (W_flow.transpose() * W_).trace();
  EXPECT_NEAR(kA2 / 2 * turning + kB2 * v_flow.dot(v_), slope, 1e-5 * std::abs(slope));
  // The printed factor (n - 2) / 2 is that 1/2 for n = 3 alone. In the plane it gives rotations no
  // length, although F changes with them: there is no gradient.
  const double printed = (GetParam() - 2) / 2.0;
  EXPECT_EQ(printed == 0.5, GetParam() == 3);
  EXPECT_EQ(printed == 0, GetParam() == 2);
  EXPECT_GT(std::abs(turning), 1e-3);
}

INSTANTIATE_TEST_SUITE_P(PlaneSpaceAndBeyond, FlowInDimension, testing::Values(2, 3, 4));

}  // namespace
}  // namespace cvo_slam
