// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>

#include <gtest/gtest.h>

#include "cvo_slam/backend/between_factor_internal.h"
#include "cvo_slam/bench/graph_samples.h"
#include "cvo_slam/core/pose_graph.h"

namespace cvo_slam {
namespace {

struct Sample {
  SE3 a;
  SE3 b;
  SE3 T_a_b;
  Matrix6 information;
};

/// Random poses and a measurement off by about `error` [m, rad], with full information.
std::vector<Sample> samples(double error) {
  std::mt19937 rng(5);
  std::vector<Sample> result;
  for (int i = 0; i < 30; ++i) {
    const SE3 a = SE3::exp(random_tangent(rng, 3, 1));
    const SE3 b = SE3::exp(random_tangent(rng, 3, 1));
    Matrix6 root;
    for (int k = 0; k < 6; ++k) root.col(k) = random_tangent(rng, 1, 1);
    result.push_back({a, b, a.inverse() * b * SE3::exp(random_tangent(rng, error, error)),
                      root * root.transpose()});
  }
  return result;
}

Vector6 whitened(const Sample& s, const SE3& a, const SE3& b) {
  return square_root_of_information(s.information) * between_residual(a, b, s.T_a_b);
}

/// A whitened residual with its derivatives by right perturbations of the two poses.
struct Evaluation {
  Vector6 residual;
  Vector6 residual_alone;  ///< evaluated without derivatives
  Matrix6 J_a;
  Matrix6 J_b;
};

/// Returns the derivative by right perturbations of a pose, from that by its seven values.
Matrix6 by_tangent(const Eigen::Matrix<double, 6, 7, Eigen::RowMajor>& jacobian,
                   const PoseVector& pose) {
  const Eigen::Quaterniond q(pose[6], pose[3], pose[4], pose[5]);
  Eigen::Matrix<double, 7, 6> plus = Eigen::Matrix<double, 7, 6>::Zero();
  plus.topLeftCorner<3, 3>() = q.toRotationMatrix();
  for (int k = 0; k < 3; ++k) {
    const Vector3 half = 0.5 * Vector3::Unit(k);
    plus.col(3 + k).tail<4>() = (q * Eigen::Quaterniond(0, half.x(), half.y(), half.z())).coeffs();
  }
  return jacobian * plus;
}

Evaluation evaluate(const Sample& s, const PoseVector& a, const PoseVector& b) {
  const BetweenFactor factor(s.T_a_b, s.information);
  const std::array<const double*, 2> poses = {a.data(), b.data()};
  Eigen::Matrix<double, 6, 7, Eigen::RowMajor> J_a;
  Eigen::Matrix<double, 6, 7, Eigen::RowMajor> J_b;
  std::array<double*, 2> jacobians = {J_a.data(), J_b.data()};
  Evaluation result;
  EXPECT_TRUE(factor.Evaluate(poses.data(), result.residual.data(), jacobians.data()));
  EXPECT_TRUE(factor.Evaluate(poses.data(), result.residual_alone.data(), nullptr));
  result.J_a = by_tangent(J_a, a);
  result.J_b = by_tangent(J_b, b);
  return result;
}

Evaluation evaluate(const Sample& s) { return evaluate(s, to_vector(s.a), to_vector(s.b)); }

TEST(BetweenFactor, ResidualIsTheWhitenedOneOfTheCost) {
  for (const Sample& s : samples(0.5)) {
    const Evaluation evaluation = evaluate(s);
    EXPECT_LT((evaluation.residual - whitened(s, s.a, s.b)).norm(), 1e-12);
    EXPECT_LT((evaluation.residual_alone - evaluation.residual).norm(), 1e-12);
  }
}

/// The sign of a quaternion is arbitrary and must not matter.
TEST(BetweenFactor, SignsOfQuaternionsDoNotMatter) {
  for (const Sample& s : samples(0.5)) {
    PoseVector flipped = to_vector(s.a);
    flipped.tail<4>() *= -1;
    EXPECT_LT((evaluate(s, flipped, to_vector(s.b)).residual - evaluate(s).residual).norm(), 1e-12);
  }
}

TEST(BetweenFactor, JacobiansMatchNumericDerivatives) {
  constexpr double kStep = 1e-6;  // central differences: errors of 1e-12 cut off, 1e-10 rounded
  for (const double error : {1e-9, 0.1, 1.0}) {
    for (const Sample& s : samples(error)) {
      const Evaluation evaluation = evaluate(s);
      for (int k = 0; k < 6; ++k) {
        const SE3 plus = SE3::exp(kStep * Vector6::Unit(k));
        const SE3 minus = plus.inverse();
        const Vector6 d_a =
            (whitened(s, s.a * plus, s.b) - whitened(s, s.a * minus, s.b)) / (2 * kStep);
        const Vector6 d_b =
            (whitened(s, s.a, s.b * plus) - whitened(s, s.a, s.b * minus)) / (2 * kStep);
        EXPECT_LT((evaluation.J_a.col(k) - d_a).norm(), 1e-7);
        EXPECT_LT((evaluation.J_b.col(k) - d_b).norm(), 1e-7);
      }
    }
  }
}

/// A block that is held has no Jacobian; the other one is computed all the same.
TEST(BetweenFactor, JacobiansAreOptional) {
  const Sample s = samples(0.1)[0];
  const BetweenFactor factor(s.T_a_b, s.information);
  const PoseVector a = to_vector(s.a);
  const PoseVector b = to_vector(s.b);
  const std::array<const double*, 2> poses = {a.data(), b.data()};
  Vector6 residual;
  Eigen::Matrix<double, 6, 7, Eigen::RowMajor> jacobian;
  std::array<double*, 2> only_b = {nullptr, jacobian.data()};
  ASSERT_TRUE(factor.Evaluate(poses.data(), residual.data(), only_b.data()));
  EXPECT_EQ(by_tangent(jacobian, b), evaluate(s).J_b);
  std::array<double*, 2> only_a = {jacobian.data(), nullptr};
  ASSERT_TRUE(factor.Evaluate(poses.data(), residual.data(), only_a.data()));
  EXPECT_EQ(by_tangent(jacobian, a), evaluate(s).J_a);
}

}  // namespace
}  // namespace cvo_slam
