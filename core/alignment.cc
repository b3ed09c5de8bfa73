// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/core/alignment.h"

#include <cmath>

#include <Eigen/LU>
#include <Eigen/SVD>
#include <fmt/format.h>

#include "cvo_slam/core/error.h"

namespace cvo_slam {
namespace {

/// Mean positions and the moments of the deviations from them.
struct Moments {
  Vector3 mean_reference = Vector3::Zero();
  Vector3 mean_estimate = Vector3::Zero();
  Matrix3 covariance = Matrix3::Zero();  ///< E[reference estimate^T]
  double variance_reference = 0;         ///< E[|reference|^2]
  double variance_estimate = 0;
};

Moments moments_of(const std::vector<MatchedPose>& matches) {
  const auto count = static_cast<double>(matches.size());
  Moments m;
  for (const auto& match : matches) {
    m.mean_reference += match.reference.translation() / count;
    m.mean_estimate += match.estimate.translation() / count;
  }
  for (const auto& match : matches) {
    const Vector3 y = match.reference.translation() - m.mean_reference;
    const Vector3 x = match.estimate.translation() - m.mean_estimate;
    m.covariance += y * x.transpose() / count;
    m.variance_reference += y.squaredNorm() / count;
    m.variance_estimate += x.squaredNorm() / count;
  }
  return m;
}

/// The rotation is unique where the covariance has two singular values above rounding: with
/// variances of the positions as the measure, 1e-10 is an extent across of 1e-5 of the length.
bool is_unique(const Moments& m, const Vector3& singular_values) {
  constexpr double kRelativeRank = 1e-10;
  const double size = std::sqrt(m.variance_reference * m.variance_estimate);
  return size > 0 && singular_values(1) > kRelativeRank * size;
}

}  // namespace

SE3 Similarity::operator*(const SE3& pose) const {
  return T_reference_estimate * SE3(pose.rotation(), scale * pose.translation());
}

Similarity align_positions(const std::vector<MatchedPose>& matches, Alignment alignment) {
  if (alignment == Alignment::kNone) return {};
  constexpr std::size_t kMinMatches = 3;
  if (matches.size() < kMinMatches) {
    throw DataError(
        fmt::format("alignment needs at least 3 matched poses, found {}; evaluate "
                    "without alignment",
                    matches.size()));
  }
  const Moments m = moments_of(matches);
  const Eigen::JacobiSVD<Matrix3> svd(m.covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  if (!is_unique(m, svd.singularValues())) {
    throw DataError(
        "alignment is not unique: the positions lie on one line or point; evaluate without "
        "alignment");
  }
  const double handedness = (svd.matrixU() * svd.matrixV().transpose()).determinant();
  const Vector3 signs(1, 1, handedness < 0 ? -1 : 1);
  const Matrix3 rotation = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
  const double scale =
      alignment == Alignment::kSim3 ? svd.singularValues().dot(signs) / m.variance_estimate : 1.0;
  return {SE3(rotation, m.mean_reference - scale * (rotation * m.mean_estimate)), scale};
}

std::vector<StampedPose> transformed(const Similarity& similarity, std::vector<StampedPose> poses) {
  for (auto& pose : poses) pose.T_world_camera = similarity * pose.T_world_camera;
  return poses;
}

}  // namespace cvo_slam
