// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <opencv2/calib3d.hpp>

#include "cvo_slam/loop/pose_search_internal.h"

namespace cvo_slam {
namespace {

using Triple = std::array<PointPair, 3>;

/// Returns a triangle with one point per column.
template <typename Position>
Matrix3 corners(const Triple& triple, const Position& position) {
  Matrix3 result;
  for (int i = 0; i < 3; ++i) result.col(i) = position(triple[static_cast<std::size_t>(i)]);
  return result;
}

/// Returns true if the corners are too close together or nearly on a line, so that they do not
/// determine a rotation.
bool is_degenerate(const Matrix3& triangle) {
  const Vector3 first = triangle.col(1) - triangle.col(0);
  const Vector3 second = triangle.col(2) - triangle.col(0);
  constexpr double kSmallestSine = 0.05;
  constexpr double kShortest = 0.02;  // [m]
  const double lengths = first.norm() * second.norm();
  return lengths < kShortest * kShortest || first.cross(second).norm() < kSmallestSine * lengths;
}

/// Returns true if the lengths of no side differ by more than the depth noise allows.
bool are_congruent(const Matrix3& a, const Matrix3& b, const PairModel& model) {
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const double length_a = (a.col(i) - a.col(j)).norm();
    const double length_b = (b.col(i) - b.col(j)).norm();
    const double deviation =
        model.depth_deviation(std::max(a.row(2).maxCoeff(), b.row(2).maxCoeff()));
    constexpr double kDeviations = 6;  // three for each end
    if (std::abs(length_a - length_b) > kDeviations * deviation) return false;
  }
  return true;
}

/// Returns the rigid motion of least squared distances (S. Umeyama, PAMI 1991, without the scale).
SE3 align_triangles(const Matrix3& a, const Matrix3& b) {
  const Eigen::Matrix4d T_a_b = Eigen::umeyama(b, a, false);
  return {T_a_b.topLeftCorner<3, 3>(), T_a_b.topRightCorner<3, 1>()};
}

/// Returns the poses T_camera_points of a camera that sees three points (columns) in the given
/// features.
template <typename Seen>
std::vector<SE3> perspective_poses(const Matrix3& points, const Triple& triple, const Seen& seen) {
  std::vector<cv::Point3d> object;
  std::vector<cv::Point2d> image;
  for (std::size_t i = 0; i < triple.size(); ++i) {
    const auto column = static_cast<Eigen::Index>(i);
    object.emplace_back(points(0, column), points(1, column), points(2, column));
    const OrbFeature& feature = seen(triple[i]);
    image.emplace_back(feature.x, feature.y);
  }
  std::vector<cv::Mat> rotations;
  std::vector<cv::Mat> translations;
  cv::solveP3P(object, image, cv::Matx33d::eye(), cv::noArray(), rotations, translations,
               cv::SOLVEPNP_AP3P);
  std::vector<SE3> poses;
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    const cv::Vec3d w(rotations[i]);
    const cv::Vec3d t(translations[i]);
    const SE3 pose(so3_exp({w[0], w[1], w[2]}), {t[0], t[1], t[2]});
    if (pose.matrix().allFinite()) poses.push_back(pose);
  }
  return poses;
}

/// Returns the poses T_a_b that agree with a triple.
std::vector<SE3> poses_of(const Triple& triple, const PairModel& model) {
  const auto all_have = [&](OrbFeature PointPair::*side) {
    return std::all_of(triple.begin(), triple.end(),
                       [&](const PointPair& pair) { return (pair.*side).has_depth(); });
  };
  const auto triangle = [&](OrbFeature PointPair::*side) {
    return corners(triple, [&](const PointPair& pair) { return (pair.*side).position(); });
  };
  const bool in_a = all_have(&PointPair::a);
  const bool in_b = all_have(&PointPair::b);
  if (in_a && in_b) {
    const Matrix3 a = triangle(&PointPair::a);
    const Matrix3 b = triangle(&PointPair::b);
    if (is_degenerate(a) || is_degenerate(b) || !are_congruent(a, b, model)) return {};
    return {align_triangles(a, b)};
  }
  if (in_b) {
    const Matrix3 b = triangle(&PointPair::b);
    if (is_degenerate(b)) return {};
    return perspective_poses(b, triple, [](const PointPair& pair) { return pair.a; });
  }
  if (!in_a) return {};
  const Matrix3 a = triangle(&PointPair::a);
  if (is_degenerate(a)) return {};
  auto poses = perspective_poses(a, triple, [](const PointPair& pair) { return pair.b; });
  for (SE3& pose : poses) pose = pose.inverse();
  return poses;
}

Triple draw(std::span<const PointPair> pairs, Random& random) {
  std::array<std::uint64_t, 3> indices{};
  do {
    for (auto& index : indices) index = random.below(pairs.size());
  } while (indices[0] == indices[1] || indices[1] == indices[2] || indices[2] == indices[0]);
  return {pairs[indices[0]], pairs[indices[1]], pairs[indices[2]]};
}

/// Returns the sum of truncated errors; lower is better.
double cost_of(const SE3& T_a_b, std::span<const PointPair> pairs, const PairModel& model) {
  const SE3 T_b_a = T_a_b.inverse();
  double cost = 0;
  for (const PointPair& pair : pairs) cost += std::min(1.0, model.error(T_a_b, T_b_a, pair));
  return cost;
}

/// Returns the number of draws after which one was a triple of inliers with 99.9 % probability.
int draws_needed(std::size_t inliers, std::size_t pairs) {
  const double share = static_cast<double>(inliers) / static_cast<double>(pairs);
  const double miss = 1 - share * share * share;
  if (miss <= 0) return 1;
  constexpr double kLogOfFailure = -6.9;
  constexpr double kMost = 1e6;
  return static_cast<int>(std::min(kMost, std::ceil(kLogOfFailure / std::log(miss))));
}

/// The best pose so far.
class Best {
 public:
  Best(std::span<const PointPair> pairs, const PairModel& model)
      : pairs_(pairs), model_(model), cost_(static_cast<double>(pairs.size())) {}

  /// Takes a pose and refines it if it is better than the best so far. Returns true if it is.
  bool see(const SE3& T_a_b) {
    if (!take(T_a_b)) return false;
    constexpr int kRefinements = 3;  // a refined pose has other inliers
    for (int i = 0; i < kRefinements; ++i) {
      const auto inliers = inliers_of(*pose_, pairs_, model_);
      if (inliers.size() <= 3 || !take(model_.refine(*pose_, inliers).T_a_b)) break;
    }
    return true;
  }

  [[nodiscard]] std::size_t inliers() const { return inliers_of(*pose_, pairs_, model_).size(); }
  [[nodiscard]] const std::optional<SE3>& pose() const { return pose_; }

 private:
  bool take(const SE3& T_a_b) {
    const double cost = cost_of(T_a_b, pairs_, model_);
    if (cost >= cost_) return false;
    cost_ = cost;
    pose_ = T_a_b;
    return true;
  }

  std::span<const PointPair> pairs_;
  const PairModel& model_;
  double cost_;
  std::optional<SE3> pose_;
};

}  // namespace

std::vector<PointPair> inliers_of(const SE3& T_a_b, std::span<const PointPair> pairs,
                                  const PairModel& model) {
  const SE3 T_b_a = T_a_b.inverse();
  std::vector<PointPair> inliers;
  for (const PointPair& pair : pairs) {
    if (model.error(T_a_b, T_b_a, pair) <= 1) inliers.push_back(pair);
  }
  return inliers;
}

std::optional<SE3> search_pose(std::span<const PointPair> pairs, const PairModel& model,
                               int iterations, Random random) {
  if (pairs.size() < 3) return std::nullopt;
  Best best(pairs, model);
  for (int i = 0; i < iterations; ++i) {
    for (const SE3& pose : poses_of(draw(pairs, random), model)) {
      if (!best.see(pose)) continue;
      iterations = std::min(iterations, draws_needed(best.inliers(), pairs.size()));
    }
  }
  return best.pose();
}

}  // namespace cvo_slam
