// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/loop/loop_options.h"
#include "cvo_slam/loop/orb_features.h"

namespace cvo_slam {

/// A point as two images see it. At least one of the two has a depth.
struct PointPair {
  OrbFeature a;
  OrbFeature b;
};

/// A pose and how certain it is.
struct PoseEstimate {
  SE3 T_a_b;
  Matrix6 information = Matrix6::Zero();  ///< of a right perturbation
};

struct NormalEquations;

/// What a pose of image b in image a says about pairs. Pixels are measured at the level of the
/// pyramid on which a corner was found.
class PairModel {
 public:
  PairModel(const PinholeCamera& camera, const VerificationOptions& options);

  /// The largest of the squared errors of what can be compared, in units of what is allowed:
  /// a's point in image b, b's point in image a, and the depth where both know it. Above 1 the pair
  /// is an outlier.
  [[nodiscard]] double error(const SE3& T_a_b, const SE3& T_b_a, const PointPair& pair) const;

  /// Least squares on pairs that are inliers, by Gauss-Newton with Huber's weights, from a start
  /// nearby. The information is no more than the residuals justify.
  [[nodiscard]] PoseEstimate refine(const SE3& T_a_b, std::span<const PointPair> inliers) const;

  /// Standard deviation of a depth [m].
  [[nodiscard]] double depth_deviation(double depth) const;

 private:
  void add_pair(const SE3& T_a_b, const SE3& T_b_a, const PointPair& pair,
                NormalEquations& equations) const;
  [[nodiscard]] double pixel_error(const Vector3& position, const OrbFeature& feature) const;

  double fx_;
  double fy_;
  VerificationOptions options_;
};

}  // namespace cvo_slam
