// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "cvo_slam/backend/between_factor_internal.h"
#include "cvo_slam/backend/pose_manifold_internal.h"
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

TEST(BetweenFactor, ResidualIsTheWhitenedOneOfTheCost) {
  for (const Sample& s : samples(0.5)) {
    const BetweenFactor factor(s.T_a_b, s.information);
    const Vector6 r = factor.residual(to_vector(s.a), to_vector(s.b));
    EXPECT_LT((r - whitened(s, s.a, s.b)).norm(), 1e-12);
    LinearizedEdge edge;
    factor.linearize(to_vector(s.a), to_vector(s.b), edge);
    EXPECT_LT((edge.residual - r).norm(), 1e-12);
  }
}

/// The signs of all four quaternions are arbitrary and must not matter.
TEST(BetweenFactor, SignsOfQuaternionsDoNotMatter) {
  for (const Sample& s : samples(0.5)) {
    const BetweenFactor factor(s.T_a_b, s.information);
    PoseVector flipped = to_vector(s.a);
    flipped.tail<4>() *= -1;
    EXPECT_LT(
        (factor.residual(flipped, to_vector(s.b)) - factor.residual(to_vector(s.a), to_vector(s.b)))
            .norm(),
        1e-12);
  }
}

Matrix6 by_tangent(const PoseJacobian& jacobian, const SE3& pose) {
  Eigen::Matrix<double, 7, 6, Eigen::RowMajor> plus;
  PoseManifold().PlusJacobian(to_vector(pose).data(), plus.data());
  return jacobian * plus;
}

TEST(BetweenFactor, JacobiansMatchNumericDerivatives) {
  constexpr double kStep = 1e-6;  // central differences: errors of 1e-12 cut off, 1e-10 rounded
  for (const double error : {1e-9, 0.1, 1.0}) {
    for (const Sample& s : samples(error)) {
      LinearizedEdge edge;
      BetweenFactor(s.T_a_b, s.information).linearize(to_vector(s.a), to_vector(s.b), edge);
      const Matrix6 J_a = by_tangent(edge.jacobian_a, s.a);
      const Matrix6 J_b = by_tangent(edge.jacobian_b, s.b);
      for (int k = 0; k < 6; ++k) {
        const SE3 plus = SE3::exp(kStep * Vector6::Unit(k));
        const SE3 minus = plus.inverse();
        const Vector6 d_a =
            (whitened(s, s.a * plus, s.b) - whitened(s, s.a * minus, s.b)) / (2 * kStep);
        const Vector6 d_b =
            (whitened(s, s.a, s.b * plus) - whitened(s, s.a, s.b * minus)) / (2 * kStep);
        EXPECT_LT((J_a.col(k) - d_a).norm(), 1e-7);
        EXPECT_LT((J_b.col(k) - d_b).norm(), 1e-7);
      }
    }
  }
}

}  // namespace
}  // namespace cvo_slam
