// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "cvo_slam/frontend/tracking_doubt_internal.h"

namespace cvo_slam {
namespace {

double largest_sigma(const Matrix3& covariance) {
  const Eigen::SelfAdjointEigenSolver<Matrix3> solver(covariance, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, solver.eigenvalues()[2]));
}

bool is_near(const SE3& difference) {
  constexpr double kTranslation = 0.06;  // [m]; features of blurred images are as inexact
  constexpr double kRotation = 0.06;     // [rad]
  return difference.translation().norm() < kTranslation && difference.angle() < kRotation;
}

}  // namespace

double doubt_of(const DoubtEvidence& evidence) {
  constexpr double kMillimetre = 1e-3;
  constexpr double kStep = 0.02;  // [m, rad]; what a hand's velocity changes by in a frame
  constexpr double kRate = 30;    // [1/s]
  // One for each term, in the order of bench/fit_doubt.py.
  constexpr std::array kCoefficients = {-1.858, -5.452, -1.590, 0.023, 2.874,
                                        0.138,  0.983,  -4.338, 2.294};
  const std::array<double, kCoefficients.size()> terms = {
      1,
      evidence.overlap,
      std::min(evidence.relative_cos_theta, 1.5),
      std::log(evidence.sigma / kMillimetre + 1e-3),
      std::log1p(evidence.surprise / kStep),
      std::log1p(kRate * std::max(evidence.seconds, 0.0)),
      std::min(evidence.rival, 1.0),
      evidence.features == FeatureOpinion::kAgrees ? 1.0 : 0.0,
      evidence.features == FeatureOpinion::kElsewhere ? 1.0 : 0.0};
  const double sum = std::inner_product(terms.begin(), terms.end(), kCoefficients.begin(), 0.0);
  return 1 / (1 + std::exp(-sum));
}

bool are_apart(const SE3& T_fixed_a, const Matrix6& covariance_a, const SE3& T_fixed_b,
               const Matrix6& covariance_b) {
  constexpr double kChiSquare = 22.5;  // of six degrees of freedom, at 99.9 %
  const SE3 T_a_b = T_fixed_a.inverse() * T_fixed_b;
  if (is_near(T_a_b)) return false;
  const Vector6 difference = T_a_b.log();
  const AlignedMatrix6 to_b = T_a_b.inverse().adjoint();  // of a perturbation at a
  const AlignedMatrix6 covariance = to_b * covariance_a * to_b.transpose() + covariance_b;
  return difference.dot(covariance.ldlt().solve(difference)) > kChiSquare;
}

FeatureOpinion opinion_on(const SE3& T_fixed_moving, const SE3& from_features) {
  return is_near(from_features.inverse() * T_fixed_moving) ? FeatureOpinion::kAgrees
                                                           : FeatureOpinion::kElsewhere;
}

void UsualSimilarity::add(double cos_theta) {
  constexpr int kMemory = 100;
  count_ = std::min(count_ + 1, kMemory);
  mean_ += (cos_theta - mean_) / count_;
}

double UsualSimilarity::share(double cos_theta) const {
  return count_ == 0 || mean_ <= 0 ? 1 : cos_theta / mean_;
}

double surprise_of(const SE3& T_predicted_camera) {
  return std::max(T_predicted_camera.translation().norm(), T_predicted_camera.angle());
}

DoubtEvidence evidence_of(const RegistrationResult& result, double surprise, double seconds,
                          const UsualSimilarity& usual) {
  const Matrix6& covariance = result.covariance;
  return {result.overlap,
          usual.share(result.cos_theta),
          std::max(largest_sigma(covariance.topLeftCorner<3, 3>()),
                   largest_sigma(covariance.bottomRightCorner<3, 3>())),
          surprise,
          seconds,
          0,
          FeatureOpinion::kNone};
}

}  // namespace cvo_slam
