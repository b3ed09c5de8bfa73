// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "cvo_slam/core/saved_state.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/frontend/registration.h"
#include "cvo_slam/frontend/tracker.h"

namespace cvo_slam {

/// What a pose from the features of the two images says of a registration.
enum class FeatureOpinion {
  kNone,       ///< nobody asked, or too few features match
  kAgrees,     ///< it is near
  kElsewhere,  ///< it is elsewhere
};

/// What tells right registrations from wrong ones. Translations [m] and rotations [rad] count
/// alike: what a rotation moves is a metre or two away.
struct DoubtEvidence {
  double overlap = 0;             ///< RegistrationResult::overlap
  double relative_cos_theta = 0;  ///< its cos_theta, as a share of what is usual
  double sigma = 0;     ///< the larger standard deviation, each in its least certain direction
  double surprise = 0;  ///< how far it is from where it was predicted: surprise_of()
  double seconds = 0;   ///< time since the last tracked frame
  /// The cos_theta of the best answer elsewhere that a registration from another start gave, as a
  /// share of its own; 0 if there is none.
  double rival = 0;
  FeatureOpinion features = FeatureOpinion::kNone;
};

/// Returns true if two answers of registrations of one frame are elsewhere: by more than 6 cm or
/// 0.06 rad, and by more than their covariances explain.
[[nodiscard]] bool are_apart(const SE3& T_fixed_a, const Matrix6& covariance_a,
                             const SE3& T_fixed_b, const Matrix6& covariance_b);

/// Compares a registration with T_fixed_moving from features.
[[nodiscard]] FeatureOpinion opinion_on(const SE3& T_fixed_moving, const SE3& from_features);

/// Returns the probability that a registration is wrong by more than 5 cm or 3 degrees: a logistic
/// model that was fitted to recordings with their true poses (bench/fit_doubt.py,
/// docs/results/doubt.md).
[[nodiscard]] double doubt_of(const DoubtEvidence& evidence);

/// What cos_theta is usual in this scene: the mean over about the last hundred registrations.
class UsualSimilarity {
 public:
  /// Takes the cos_theta of a registration that is believed.
  void add(double cos_theta);
  /// 1 before the first one.
  [[nodiscard]] double share(double cos_theta) const;
  void exchange(SavedState& state) { state(mean_, count_); }

 private:
  double mean_ = 0;
  int count_ = 0;
};

/// Returns how far a camera is from where it was predicted, from its pose in its predicted frame:
/// the larger one of translation [m] and angle [rad].
[[nodiscard]] double surprise_of(const SE3& T_predicted_camera);

/// Returns the evidence before features and rivals are known.
[[nodiscard]] DoubtEvidence evidence_of(const RegistrationResult& result, double surprise,
                                        double seconds, const UsualSimilarity& usual);

/// Returns what the tracker knew when it judged the frame that it was given last: for those who
/// measure doubt_of(). Empty if that frame was not registered.
[[nodiscard]] std::optional<DoubtEvidence> last_evidence(const Tracker& tracker);

}  // namespace cvo_slam
