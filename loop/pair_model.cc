// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Cholesky>

#include "cvo_slam/loop/pose_search_internal.h"

namespace cvo_slam {
namespace {

/// Residuals of more standard deviations than this have a lower weight.
constexpr double kHuber = 2;
/// Largest difference between the depths of an inlier [standard deviations].
constexpr double kDepthDeviations = 3;

/// Least noise that is assumed, for cameras whose noise model is zero.
constexpr double kLeastPixelNoise = 0.01;  // [px]
constexpr double kLeastDepthNoise = 1e-5;  // [m]

/// Returns the derivative of a moved point R (p + v + w x p) + t by the tangent (v, w).
Eigen::Matrix<double, 3, 6> point_jacobian(const Matrix3& rotation, const Vector3& point) {
  Eigen::Matrix<double, 3, 6> jacobian;
  jacobian << rotation, -rotation * skew(point);
  return jacobian;
}

}  // namespace

/// The normal equations of weighted residuals.
struct NormalEquations {
  template <int kRows>
  void add(const Eigen::Matrix<double, kRows, 1>& residual,
           const Eigen::Matrix<double, kRows, 6>& jacobian, double weight) {
    const double norm = residual.norm();
    const double robust = weight * (norm > kHuber ? kHuber / norm : 1.0);
    H += robust * jacobian.transpose() * jacobian;
    g += robust * jacobian.transpose() * residual;
    chi2 += robust * norm * norm;
    count += weight * kRows;
  }

  Eigen::Matrix<double, 6, 6> H = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 1> g = Eigen::Matrix<double, 6, 1>::Zero();
  double chi2 = 0;
  double count = 0;  // number of residuals
};

namespace {

/// Adds the difference between the projection of a point, given by `position` and its Jacobian, and
/// the feature at which it was seen.
void add_pixel(NormalEquations& equations, const Vector3& position,
               const Eigen::Matrix<double, 3, 6>& jacobian, const OrbFeature& feature,
               const Eigen::Vector2d& pixels_per_deviation, double weight) {
  const double x = position.x() / position.z();
  const double y = position.y() / position.z();
  Eigen::Matrix<double, 2, 3> projection;
  projection << 1, 0, -x, 0, 1, -y;
  projection = pixels_per_deviation.asDiagonal() * projection / position.z();
  const Eigen::Vector2d residual =
      pixels_per_deviation.cwiseProduct(Eigen::Vector2d(x - feature.x, y - feature.y));
  equations.add<2>(residual, projection * jacobian, weight);
}

}  // namespace

PairModel::PairModel(const Camera& camera, double max_reprojection)
    : fx_(camera.color.fx),
      fy_(camera.color.fy),
      noise_(camera.noise),
      max_reprojection_(max_reprojection) {
  noise_.pixel = std::max(noise_.pixel, kLeastPixelNoise);
  noise_.depth_floor = std::max(noise_.depth_floor, kLeastDepthNoise);
}

double PairModel::depth_deviation(double depth) const { return noise_.sigma_z(depth); }

double PairModel::pixel_error(const Vector3& position, const OrbFeature& feature) const {
  if (position.z() <= 0) return std::numeric_limits<double>::infinity();
  const double dx = fx_ * (position.x() / position.z() - feature.x);
  const double dy = fy_ * (position.y() / position.z() - feature.y);
  const double allowed = max_reprojection_ * feature.size;
  return (dx * dx + dy * dy) / (allowed * allowed);
}

double PairModel::error(const SE3& T_a_b, const SE3& T_b_a, const PointPair& pair) const {
  double error = 0;
  if (pair.a.has_depth()) error = pixel_error(T_b_a * pair.a.position(), pair.b);
  if (!pair.b.has_depth()) return error;
  const Vector3 in_a = T_a_b * pair.b.position();
  error = std::max(error, pixel_error(in_a, pair.a));
  if (!pair.a.has_depth()) return error;
  const double allowed =
      kDepthDeviations * std::hypot(depth_deviation(pair.a.depth), depth_deviation(pair.b.depth));
  const double difference = (in_a.z() - pair.a.depth) / allowed;
  return std::max(error, difference * difference);
}

void PairModel::add_pair(const SE3& T_a_b, const SE3& T_b_a, const PointPair& pair,
                         NormalEquations& equations) const {
  const auto pixels = [&](const OrbFeature& feature) -> Eigen::Vector2d {
    return Eigen::Vector2d(fx_, fy_) / (noise_.pixel * feature.size);
  };
  // Both directions compare the same two pixels; together they count once.
  const double weight = pair.a.has_depth() && pair.b.has_depth() ? 0.5 : 1;
  if (pair.a.has_depth()) {
    const Vector3 in_b = T_b_a * pair.a.position();
    add_pixel(equations, in_b, -point_jacobian(Matrix3::Identity(), in_b), pair.b, pixels(pair.b),
              weight);
  }
  if (!pair.b.has_depth()) return;
  const Vector3 in_a = T_a_b * pair.b.position();
  const auto jacobian = point_jacobian(T_a_b.rotation(), pair.b.position());
  add_pixel(equations, in_a, jacobian, pair.a, pixels(pair.a), weight);
  if (!pair.a.has_depth()) return;
  const double deviation = std::hypot(depth_deviation(pair.a.depth), depth_deviation(pair.b.depth));
  const Eigen::Matrix<double, 1, 1> residual((in_a.z() - pair.a.depth) / deviation);
  equations.add<1>(residual, jacobian.row(2) / deviation, 1);
}

PoseEstimate PairModel::refine(const SE3& T_a_b, std::span<const PointPair> inliers) const {
  constexpr int kIterations = 10;
  constexpr double kSmallStep = 1e-7;
  PoseEstimate estimate{.T_a_b = T_a_b};
  for (int i = 0; i < kIterations; ++i) {
    NormalEquations equations;
    const SE3 T_b_a = estimate.T_a_b.inverse();
    for (const PointPair& pair : inliers) add_pair(estimate.T_a_b, T_b_a, pair, equations);
    const double variance = equations.chi2 / std::max(1.0, equations.count - 6);
    estimate.information = equations.H / std::max(1.0, variance);
    const Vector6 step = -equations.H.ldlt().solve(equations.g);
    if (!step.allFinite()) break;
    estimate.T_a_b = (estimate.T_a_b * SE3::exp(step)).normalized();
    if (step.norm() < kSmallStep) break;
  }
  return estimate;
}

}  // namespace cvo_slam
