// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "cvo_slam/core/saved_state.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/frontend/registration.h"
#include "cvo_slam/frontend/tracker.h"

namespace cvo_slam {

/// Above this doubt another opinion is asked for: at it, a fiftieth of the registrations are wrong.
constexpr double kDoubtful = 0.02;
/// Share of a cos_theta from which on another one is as good.
constexpr double kAsGood = 0.95;

/// What a judgement of a registration needs besides its result.
struct TrackingSituation {
  SE3 T_last_camera;     ///< motion since the last tracked frame
  double seconds = 0;    ///< time since the last tracked frame; positive
  double doubt = 1;      ///< as in FrameRecord
  bool is_lost = false;  ///< true if the frame before was lost
};

/// Returns why a registration is not believed; empty if it is. A lost camera may be anywhere, the
/// longer the further, and every image has something that resembles the keyframe: more overlap and
/// a larger cos_theta are asked for then. A motion above the largest speed is believed if it is not
/// doubtful otherwise: stamps may be counted and not measured.
[[nodiscard]] std::string find_fault(const RegistrationResult& result,
                                     const TrackingSituation& situation, const LostOptions& limits);

/// What a registration from one of several starts answered.
struct Answer {
  SE3 T_fixed_moving;
  Matrix6 covariance = Matrix6::Zero();
  double cos_theta = 0;
  bool is_believed = false;
};

/// Returns true if an answer is as good as a registration, and so far away that one of the two must
/// be wrong: by more than 10 cm or 5 degrees, and by more than their covariances explain.
[[nodiscard]] bool is_equal_rival(const Answer& answer, const RegistrationResult& result);

/// Decides which tracked frames become keyframes.
class KeyframePolicy {
 public:
  explicit KeyframePolicy(const KeyframeOptions& options) : options_(options) {}

  /// Tells that a keyframe was made, or made again.
  void keyframe_made();
  /// Returns why a tracked frame shall become a keyframe: "overlap", "translation" or "rotation";
  /// empty if it need not. `visible` is the share of its points that lie in the keyframe's image.
  [[nodiscard]] std::string reason(const RegistrationResult& result, double visible);
  void exchange(SavedState& state) { state(expected_overlap_); }

 private:
  KeyframeOptions options_;
  // The overlap to be expected of points in the keyframe's image. Where depth is missing in patches
  // that differ from image to image, some points never find a partner; that is no reason for a new
  // keyframe, which would be no better.
  double expected_overlap_ = 0;
};

}  // namespace cvo_slam
