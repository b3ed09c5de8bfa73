// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The derivatives of the objective against numeric differentiation of its definition.
#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "cvo_slam/frontend/objective_internal.h"
#include "cvo_slam/tests/frontend/evaluate.h"
#include "cvo_slam/tests/frontend/reference_align.h"
#include "cvo_slam/tests/frontend/test_clouds.h"

namespace cvo_slam {
namespace {

constexpr double kScale = 0.3;

/// A kernel that cuts off no pair: the objective is smooth, as differentiation needs.
KernelOptions smooth_kernel(ColorKernel color) {
  KernelOptions kernel;
  kernel.sparsification = 1e-9;
  kernel.color_kernel = color;
  return kernel;
}

class ObjectiveDerivatives : public testing::TestWithParam<ColorKernel> {
 protected:
  ObjectiveDerivatives() {
    objective_.build(fixed_, kernel_, kScale);
    value_ = evaluate(objective_, moving_, T_);
  }

  [[nodiscard]] double f(const SE3& T) const {
    return reference_objective(fixed_, moving_, T, kernel_, kScale);
  }

  KernelOptions kernel_ = smooth_kernel(GetParam());
  PointCloud fixed_ = random_cloud(60, 1);
  PointCloud moving_ = random_cloud(50, 2);
  SE3 T_ = motion(0.05, -0.03, 0.02, 0.1, -0.05, 0.2);
  Objective objective_;
  ObjectiveValue value_;
};

// Single precision inside leaves about 1e-6 of the sums' own magnitude.
constexpr double kFloatTolerance = 2e-6;

TEST_P(ObjectiveDerivatives, ValueIsTheInnerProduct) {
  EXPECT_NEAR(value_.inner_product, f(T_), kFloatTolerance * f(T_));
  EXPECT_EQ(value_.matched, moving_.size());
}

TEST_P(ObjectiveDerivatives, GradientMatchesNumericDifferentiation) {
  constexpr double kStep = 1e-5;
  for (int k = 0; k < 6; ++k) {
    const Vector6 d = kStep * Vector6::Unit(k);
    const double numeric = (f(SE3::exp(d) * T_) - f(SE3::exp(-d) * T_)) / (2 * kStep);
    EXPECT_NEAR(value_.gradient[k], numeric, kFloatTolerance * f(T_) / kScale) << k;
  }
}

/// Returns the numeric second derivative of F(move(d)) at d = 0.
template <typename Move>
Matrix6 numeric_hessian(const Move& move) {
  constexpr double kStep = 1e-4;
  Matrix6 H;
  for (int a = 0; a < 6; ++a) {
    for (int b = 0; b < 6; ++b) {
      const Vector6 da = kStep * Vector6::Unit(a);
      const Vector6 db = kStep * Vector6::Unit(b);
      H(a, b) =
          (move(da + db) - move(da - db) - move(db - da) + move(-da - db)) / (4 * kStep * kStep);
    }
  }
  return H;
}

TEST_P(ObjectiveDerivatives, HessianMatchesNumericDifferentiation) {
  const Matrix6 numeric = numeric_hessian([&](const Vector6& d) { return f(SE3::exp(d) * T_); });
  EXPECT_LT((value_.hessian + numeric).norm(), 1e-5 * numeric.norm());
}

TEST_P(ObjectiveDerivatives, AdjointTurnsItIntoTheHessianOfARightPerturbation) {
  // At a maximum the second derivative is the same in all charts.
  const SE3 T = reference_align(fixed_, fixed_, motion(0.01, 0, 0, 0, 0, 0.01), kernel_, kScale);
  const auto at_maximum = evaluate(objective_, fixed_, T);
  const Matrix6 numeric = numeric_hessian([&](const Vector6& d) {
    return reference_objective(fixed_, fixed_, T * SE3::exp(d), kernel_, kScale);
  });
  const Matrix6 adjoint = T.adjoint();
  EXPECT_LT((adjoint.transpose() * at_maximum.hessian * adjoint + numeric).norm(),
            1e-5 * numeric.norm());
}

TEST_P(ObjectiveDerivatives, MajorizerBoundsTheHessian) {
  // Curvature of exp aside, H = H0 - sum J^T (w r r^T / ell^4) J: at the maximum H <= H0.
  const auto value = evaluate(objective_, fixed_, SE3());
  const Eigen::MatrixXd difference = value.majorizer - value.hessian;
  const Eigen::VectorXd eigenvalues =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(difference).eigenvalues();
  EXPECT_GT(eigenvalues.minCoeff(), -1e-5 * eigenvalues.maxCoeff());
}

INSTANTIATE_TEST_SUITE_P(ColorKernels, ObjectiveDerivatives,
                         testing::Values(ColorKernel::kLinear, ColorKernel::kSquaredExponential));

TEST(ObjectiveOfShapedKernels, DerivativesMatchNumericDifferentiation) {
  KernelOptions kernel = smooth_kernel(ColorKernel::kSquaredExponential);
  kernel.ray_noise = 1;
  const PointCloud fixed = random_cloud(60, 1);
  PointCloud moving = random_cloud(50, 2);
  moving.ray_noise.assign(moving.size(), 0.2F);
  moving.surface_noise = 1e-4F;
  const Eigen::Vector3f n = Eigen::Vector3f(0.3F, -0.2F, 0.9F).normalized();
  moving.surfaces.assign(moving.size(), {n, 0.05F});
  const SE3 T = motion(0.05, -0.03, 0.02, 0.1, -0.05, 0.2);
  // Rays and normals are those of the pose T, also near it.
  const auto f = [&](const SE3& pose) {
    double sum = 0;
    for (std::size_t j = 0; j < moving.size(); ++j) {
      const Vector3 d = T.rotation() * moving.position(j).normalized();
      const Vector3 normal = T.rotation() * n.cast<double>();
      // A tenth of the length scale, the roughness, and a tenth of it for the noise.
      const double thickness2 = 0.03 * 0.03 + 0.05 * 0.05 + 0.03 * 0.03;
      const Matrix3 covariance = kScale * kScale * Matrix3::Identity() +
                                 (thickness2 - kScale * kScale) * normal * normal.transpose() +
                                 0.04 * d * d.transpose();
      for (std::size_t i = 0; i < fixed.size(); ++i) {
        const Vector3 r = fixed.position(i) - pose * moving.position(j);
        sum += label_product(kernel, fixed, i, moving, j) * kernel.sigma * kernel.sigma *
               std::exp(-0.5 * r.dot(covariance.inverse() * r));
      }
    }
    return sum;
  };
  Objective objective;
  objective.build(fixed, kernel, kScale);
  const auto value = evaluate(objective, moving, T);
  EXPECT_NEAR(value.inner_product, f(T), 1e-5 * f(T));
  constexpr double kStep = 1e-5;
  for (int k = 0; k < 6; ++k) {
    const Vector6 d = kStep * Vector6::Unit(k);
    const double numeric = (f(SE3::exp(d) * T) - f(SE3::exp(-d) * T)) / (2 * kStep);
    EXPECT_NEAR(value.gradient[k], numeric, 1e-5 * f(T) / kScale) << k;
  }
  const Matrix6 numeric = numeric_hessian([&](const Vector6& d) { return f(SE3::exp(d) * T); });
  EXPECT_LT((value.hessian + numeric).norm(), 1e-4 * numeric.norm());
  const Matrix6 difference = value.majorizer - value.hessian;
  EXPECT_TRUE(value.majorizer.isApprox(value.majorizer.transpose(), 1e-9));
  EXPECT_GT(difference.trace(), 0);
}

TEST(Objective, IsContinuousWhereTheThresholdCuts) {
  // The inner product jumps by the threshold where a pair leaves the support; `value` must not.
  PointCloud point = random_cloud(1, 3);
  KernelOptions kernel;
  Objective objective;
  objective.build(point, kernel, 0.1);
  const double radius = support_radius(kernel, 0.1);
  const auto at = [&](double distance) {
    return evaluate(objective, point, motion(distance, 0, 0, 0, 0, 0));
  };
  EXPECT_GT(at(radius - 1e-4).inner_product, 0.99 * kernel.sparsification);
  EXPECT_EQ(at(radius + 1e-4).inner_product, 0.0);
  // 0.1 mm inside, k exceeds the threshold by k distance / ell^2 * 1e-4 m, which is 2 % of it.
  EXPECT_LT(at(radius - 1e-4).value, 0.03 * kernel.sparsification);
  EXPECT_EQ(at(radius + 1e-4).matched, 0U);
}

TEST(Objective, IsTheSameToTheBitForAnyNumberOfThreads) {
  const PointCloud fixed = random_cloud(2000, 4);
  const PointCloud moving = random_cloud(1500, 5);
  Objective objective;
  objective.build(fixed, KernelOptions(), 0.05);
  const auto one = evaluate(objective, moving, SE3(), Executor(1));
  for (const int threads : {2, 8}) {
    const auto many = evaluate(objective, moving, SE3(), Executor(threads));
    EXPECT_EQ(one.value, many.value);
    EXPECT_EQ(one.gradient, many.gradient);
    EXPECT_EQ(one.hessian, many.hessian);
  }
}

}  // namespace
}  // namespace cvo_slam
