// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The formulas of the flow, each against numeric differentiation of F and of
// G(t) = F(h exp(t xi)) - F(h). If the paper prints another formula, a test shows that it fails.
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <gtest/gtest.h>

#include "cvo_slam/frontend/solvers_internal.h"
#include "cvo_slam/tests/frontend/reference_align.h"
#include "cvo_slam/tests/frontend/test_clouds.h"

namespace cvo_slam {
namespace {

constexpr double kScale = 0.3;
constexpr double kA2 = 7;
constexpr double kB2 = 7;

class GradientFlow : public testing::Test {
 protected:
  GradientFlow() {
    kernel_.sparsification = 1e-9;  // smooth
    kernel_.color_kernel = ColorKernel::kLinear;
    level_.build(fixed_, kernel_, kScale);
  }

  [[nodiscard]] FlowDirection flow() { return flow_direction(objective_.evaluate(T_), kA2, kB2); }

  /// Returns F(h exp(t xi)) for T = h^-1: the moved points go to exp(-t xi) T z.
  [[nodiscard]] double f(const FlowDirection& xi, double t) const {
    Vector6 tangent;
    tangent << -t * xi.v, -t * xi.omega;
    return reference_objective(fixed_, moving_, SE3::exp(tangent) * T_, kernel_, kScale);
  }

  /// Returns Taylor coefficients 1 to 4 of f(xi, t) from a polynomial through Chebyshev nodes.
  [[nodiscard]] std::array<double, 4> numeric_expansion(const FlowDirection& xi) const {
    constexpr int kNodes = 17;
    constexpr double kReach = 0.5;
    Eigen::MatrixXd vandermonde(kNodes, kNodes);
    Eigen::VectorXd values(kNodes);
    for (int i = 0; i < kNodes; ++i) {
      const double s = std::cos(M_PI * (i + 0.5) / kNodes);
      for (int k = 0; k < kNodes; ++k) vandermonde(i, k) = std::pow(s, k);
      values[i] = f(xi, kReach * s);
    }
    const Eigen::VectorXd c = vandermonde.colPivHouseholderQr().solve(values);
    std::array<double, 4> g{};
    for (int k = 1; k <= 4; ++k) g[static_cast<std::size_t>(k - 1)] = c[k] / std::pow(kReach, k);
    return g;
  }

  KernelOptions kernel_;
  PointCloud fixed_ = random_cloud(40, 1);
  PointCloud moving_ = random_cloud(30, 2);
  SE3 T_ = motion(0.05, -0.03, 0.02, 0.1, -0.05, 0.2);
  Objective level_;
  PairTable pairs_;
  Executor executor_;
  PoseObjective objective_{level_, moving_, moving_.size(), pairs_, executor_};
  /// Returns a direction whose unit of time moves points by about half a length scale.
  FlowDirection direction_{Vector3(0.06, -0.08, 0.05), Vector3(-0.05, 0.07, 0.03)};
};

// Single precision within a point leaves about 1e-6 of the sums' own magnitude.
constexpr double kFloatTolerance = 4e-6;

TEST_F(GradientFlow, DirectionIsTheGradientInTheMetric) {
  // <flow, xi> = a^2 omega.xi_omega + b^2 v.xi_v must be dF/dt along every xi.
  const FlowDirection flow = this->flow();
  constexpr double kStep = 1e-5;
  for (int k = 0; k < 6; ++k) {
    FlowDirection xi;
    (k < 3 ? xi.v[k] : xi.omega[k - 3]) = 1;
    const double numeric = (f(xi, kStep) - f(xi, -kStep)) / (2 * kStep);
    const double analytic = kA2 * flow.omega.dot(xi.omega) + kB2 * flow.v.dot(xi.v);
    EXPECT_NEAR(analytic, numeric, kFloatTolerance * f(xi, 0) / kScale) << k;
  }
}

TEST_F(GradientFlow, ThePrintedSignOfTheTranslationDescends) {
  const FlowDirection ours = flow();
  const FlowDirection printed{Vector3::Zero(), -ours.v};
  EXPECT_LT(f(printed, 1e-4), f(printed, 0));
}

TEST_F(GradientFlow, EveryCoefficientOfTheExpansionMatches) {
  const auto analytic = step_expansion(objective_, T_, direction_);
  const auto numeric = numeric_expansion(direction_);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(analytic[k], numeric[k], kFloatTolerance * std::abs(numeric[k])) << "g" << k + 1;
  }
}

TEST_F(GradientFlow, ThePrintedExpansionWithoutFactorialsIsWrong) {
  // The paper's points go to z - t u - t^2 w^ u ..., without 1/k! and alternating signs: gamma =
  // -1/(2 ell^2) (|u|^2 + 2 <w^ u, d>). The second coefficient is off by far more than rounding.
  const double inv2 = 1 / (kScale * kScale);
  double g2 = 0;
  for (std::size_t j = 0; j < moving_.size(); ++j) {
    const Vector3 z = T_ * moving_.position(j);
    const Vector3 u = direction_.omega.cross(z) + direction_.v;
    for (std::size_t i = 0; i < fixed_.size(); ++i) {
      const Vector3 d = fixed_.position(i) - z;
      const double w = label_product(kernel_, fixed_, i, moving_, j) * kernel_.sigma *
                       kernel_.sigma * std::exp(-inv2 / 2 * d.squaredNorm());
      const double beta = -inv2 * u.dot(d);
      const double gamma = -inv2 / 2 * (u.squaredNorm() + 2 * direction_.omega.cross(u).dot(d));
      g2 += w * (gamma + beta * beta / 2);
    }
  }
  const double numeric = numeric_expansion(direction_)[1];
  EXPECT_GT(std::abs(g2 - numeric), 1e-4 * std::abs(numeric));
}

TEST(SmallestPositiveStationaryPoint, OfKnownPolynomials) {
  // G' = (t - 1)(t - 2)(t - 3) = -6 + 11 t - 6 t^2 + t^3
  EXPECT_NEAR(*smallest_positive_stationary_point({-6, 11.0 / 2, -6.0 / 3, 1.0 / 4}), 1, 1e-12);
  // G' = (t + 1)(t + 2)(2 - t): one positive root
  EXPECT_NEAR(*smallest_positive_stationary_point({4, 4.0 / 2, -1.0 / 3, -1.0 / 4}), 2, 1e-12);
  // G' = 1 - t: the cubic degenerates
  EXPECT_NEAR(*smallest_positive_stationary_point({1, -0.5, 0, 0}), 1, 1e-12);
  // G' = 1 + t^2 and G' = 1: no root
  EXPECT_FALSE(smallest_positive_stationary_point({1, 0, 1.0 / 3, 0}));
  EXPECT_FALSE(smallest_positive_stationary_point({1, 0, 0, 0}));
  EXPECT_FALSE(smallest_positive_stationary_point({0, 0, 0, 0}));
}

}  // namespace
}  // namespace cvo_slam
