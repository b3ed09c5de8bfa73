// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "cvo_slam/core/point_cloud.h"
#include "cvo_slam/core/saved_state.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/frontend/registration.h"
#include "cvo_slam/slam/slam_options.h"

namespace cvo_slam {

/// The part of a registration's error that its own covariance does not know of.
struct RegistrationNoise {
  double translation = 0;  ///< standard deviation [m]
  double rotation = 0;     ///< standard deviation [rad]

  /// Returns the covariance with this noise added.
  [[nodiscard]] Matrix6 added_to(Matrix6 covariance) const;
};

/// What is known of the pose of a pair before it is registered.
struct PairPrior {
  SE3 T_older_newer;
  Matrix6 covariance = Matrix6::Zero();  ///< of a right perturbation
};

/// The relative pose of two keyframes as it was measured.
struct PairMeasurement {
  SE3 T_older_newer;
  Matrix6 covariance = Matrix6::Identity();  ///< of a right perturbation

  void exchange(SavedState& state) { state(T_older_newer, covariance); }
};

/// The result of registering a pair: a measurement, or the reason why there is none. Figures that
/// were not computed are 0.
struct PairVerdict {
  std::optional<PairMeasurement> measurement;
  std::string reason;    ///< why the registration is not believed; empty if it is
  double overlap = 0;    ///< the lower one of the two registrations'
  double cos_theta = 0;  ///< the lower one of the two registrations'
  /// How far the two registrations, one each way, are apart.
  double round_trip_translation = 0;  ///< [m]
  double round_trip_rotation = 0;     ///< [rad]
  /// How far the measurement is from the prior.
  double correction_translation = 0;  ///< [m]
  double correction_rotation = 0;     ///< [rad]
  double error = 0;                   ///< [standard deviations]

  /// A verdict without figures.
  [[nodiscard]] static PairVerdict rejected(const std::string& reason) {
    PairVerdict verdict;
    verdict.reason = reason;
    return verdict;
  }
};

/// The first points of a cloud. Every prefix of a selected cloud is spread over the image
/// (PointSelector).
[[nodiscard]] PointCloud first_points(const PointCloud& cloud, int count);

/// Registers a new keyframe and an earlier one to each other, both ways, and judges the result.
class PairRegistration {
 public:
  PairRegistration(const RegistrationOptions& registration, int threads, const PairOptions& options,
                   const RegistrationNoise& noise);

  /// Sets the new keyframe of the pairs that follow.
  void set_newer(const PointCloud& cloud);
  /// Registers an earlier keyframe and the new one to each other, searching from T_older_newer.
  /// `prior` is null where nothing is known of the pair. `usual_cos_theta` is the mean of the
  /// registrations of consecutive keyframes; 0 if there were none.
  [[nodiscard]] PairVerdict register_both_ways(const PointCloud& older_cloud,
                                               const SE3& T_older_newer, const PairPrior* prior,
                                               double usual_cos_theta);

 private:
  PairOptions options_;
  RegistrationNoise noise_;
  Registration to_newer_;
  Registration to_older_;
  PointCloud newer_cloud_;  // the first points of the new keyframe, as those of a moving cloud
};

}  // namespace cvo_slam
