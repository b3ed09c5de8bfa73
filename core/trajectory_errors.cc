// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/core/trajectory_errors.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <fmt/format.h>

#include "cvo_slam/core/error.h"

namespace cvo_slam {
namespace {

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return (*std::max_element(values.begin(), middle) + *middle) / 2;
}

/// Matched positions, one column per match.
struct PositionPairs {
  Eigen::Matrix3Xd reference;
  Eigen::Matrix3Xd estimate;
};

PositionPairs positions_of(const std::vector<MatchedPose>& matches) {
  const auto count = static_cast<Eigen::Index>(matches.size());
  PositionPairs pairs{Eigen::Matrix3Xd(3, count), Eigen::Matrix3Xd(3, count)};
  for (Eigen::Index i = 0; i < count; ++i) {
    const MatchedPose& match = matches[static_cast<std::size_t>(i)];
    pairs.reference.col(i) = match.reference.translation();
    pairs.estimate.col(i) = match.estimate.translation();
  }
  return pairs;
}

/// Returns true if one rotation alone aligns the positions best: their cross-covariance must have
/// two singular values above rounding. Relative to the variances of the positions, 1e-10 is an
/// extent across of 1e-5 of the length.
bool is_alignment_unique(const PositionPairs& pairs) {
  constexpr double kRelativeRank = 1e-10;
  const Eigen::Matrix3Xd y = pairs.reference.colwise() - pairs.reference.rowwise().mean();
  const Eigen::Matrix3Xd x = pairs.estimate.colwise() - pairs.estimate.rowwise().mean();
  const double size = y.norm() * x.norm();
  const Vector3 singular_values = Eigen::JacobiSVD<Matrix3>(y * x.transpose()).singularValues();
  return size > 0 && singular_values(1) > kRelativeRank * size;
}

}  // namespace

Statistics summarize(std::span<const double> values) {
  Statistics result;
  if (values.empty()) return result;
  double sum = 0;
  double sum_of_squares = 0;
  for (const double value : values) {
    sum += value;
    sum_of_squares += value * value;
  }
  const auto count = static_cast<double>(values.size());
  result.count = values.size();
  result.mean = sum / count;
  result.rmse = std::sqrt(sum_of_squares / count);
  result.sse = sum_of_squares;
  // In a second pass: mean(x^2) - mean(x)^2 cancels where the errors are nearly equal.
  double squared_deviations = 0;
  for (const double value : values) {
    squared_deviations += (value - result.mean) * (value - result.mean);
  }
  result.std = std::sqrt(squared_deviations / count);
  result.median = median_of({values.begin(), values.end()});
  const auto [min, max] = std::minmax_element(values.begin(), values.end());
  result.min = *min;
  result.max = *max;
  return result;
}

Statistics in_unit(const Statistics& statistics, double factor) {
  Statistics result = statistics;
  for (double* figure :
       {&result.rmse, &result.mean, &result.median, &result.std, &result.min, &result.max}) {
    *figure *= factor;
  }
  result.sse *= factor * factor;
  return result;
}

PoseErrorStatistics summarize(const std::vector<PoseError>& errors) {
  std::vector<double> translations;
  std::vector<double> rotations;
  translations.reserve(errors.size());
  rotations.reserve(errors.size());
  for (const auto& error : errors) {
    translations.push_back(error.translation);
    rotations.push_back(error.rotation);
  }
  return {summarize(std::span<const double>(translations)),
          summarize(std::span<const double>(rotations))};
}

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
  const PositionPairs pairs = positions_of(matches);
  if (!is_alignment_unique(pairs)) {
    throw DataError(
        "alignment is not unique: the positions lie on one line or point; evaluate without "
        "alignment");
  }
  const bool with_scale = alignment == Alignment::kSim3;
  const Eigen::Matrix4d T = Eigen::umeyama(pairs.estimate, pairs.reference, with_scale);
  const double scale = with_scale ? T.topLeftCorner<3, 1>().norm() : 1;
  return {SE3(T.topLeftCorner<3, 3>() / scale, T.topRightCorner<3, 1>()), scale};
}

std::vector<StampedPose> transformed(const Similarity& similarity, std::vector<StampedPose> poses) {
  for (auto& pose : poses) pose.T_world_camera = similarity * pose.T_world_camera;
  return poses;
}

AbsoluteTrajectoryError absolute_trajectory_error(const std::vector<MatchedPose>& matches,
                                                  Alignment alignment) {
  if (matches.empty()) throw DataError("no matched pose to take the trajectory error of");
  AbsoluteTrajectoryError result;
  result.alignment = align_positions(matches, alignment);
  result.errors.reserve(matches.size());
  for (const auto& match : matches) {
    const SE3 error = match.reference.inverse() * (result.alignment * match.estimate);
    result.errors.push_back({match.stamp, error.translation().norm(), error.angle()});
  }
  result.statistics = summarize(result.errors);
  return result;
}

}  // namespace cvo_slam
