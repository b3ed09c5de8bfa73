// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/loop/orb_features.h"
#include "cvo_slam/loop/random_internal.h"

namespace cvo_slam {

/// A point as two images see it. At least one of the two features has a depth.
struct PointPair {
  OrbFeature a;
  OrbFeature b;
};

/// A pose and its certainty.
struct PoseEstimate {
  SE3 T_a_b;
  Matrix6 information = Matrix6::Zero();  ///< of a right perturbation
};

struct NormalEquations;

/// The residuals of pairs, given the pose of image b in image a. Pixel errors are measured in
/// pixels of the pyramid level on which a feature was found; noise is that of the camera.
class PairModel {
 public:
  /// `max_reprojection` is the largest pixel error of an inlier [px].
  PairModel(const Camera& camera, double max_reprojection);

  /// Returns the largest of the squared errors that a pair has, each relative to its limit: a's
  /// point in image b, b's point in image a, and the difference of depths if both are known. Above
  /// 1 the pair is an outlier.
  [[nodiscard]] double error(const SE3& T_a_b, const SE3& T_b_a, const PointPair& pair) const;

  /// Returns the least-squares pose of inliers, by Gauss-Newton with Huber's weights from a start
  /// nearby. The information is reduced if the residuals are larger than the noise explains.
  [[nodiscard]] PoseEstimate refine(const SE3& T_a_b, std::span<const PointPair> inliers) const;

  /// Returns the standard deviation of a depth [m].
  [[nodiscard]] double depth_deviation(double depth) const;

 private:
  void add_pair(const SE3& T_a_b, const SE3& T_b_a, const PointPair& pair,
                NormalEquations& equations) const;
  [[nodiscard]] double pixel_error(const Vector3& position, const OrbFeature& feature) const;

  double fx_;
  double fy_;
  SensorNoise noise_;
  double max_reprojection_;
};

/// Returns the pairs that are inliers of a pose, in their order.
[[nodiscard]] std::vector<PointPair> inliers_of(const SE3& T_a_b, std::span<const PointPair> pairs,
                                                const PairModel& model);

/// Returns the pose that explains most of the pairs, some of which are outliers: RANSAC over
/// triples (M. Fischler and R. Bolles, 1981) with truncated errors (MSAC, P. Torr and A. Zisserman,
/// 2000), where each new best pose is refined on its inliers (LO-RANSAC, O. Chum et al., 2003). A
/// triple with depths on both sides gives a pose by aligning two triangles, a triple with depths on
/// one side by the perspective of three points. The search ends after `iterations`, or earlier when
/// a better pose would have been found. Returns nothing if no triple gives a pose.
[[nodiscard]] std::optional<SE3> search_pose(std::span<const PointPair> pairs,
                                             const PairModel& model, int iterations, Random random);

}  // namespace cvo_slam
