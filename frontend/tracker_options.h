// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cvo_slam/core/options.h"
#include "cvo_slam/frontend/point_selection.h"
#include "cvo_slam/frontend/registration.h"

namespace cvo_slam {

/// What a frame is registered against.
enum class Reference {
  kKeyframe,
  kPreviousFrame,  ///< the paper's
};

/// Where a registration starts.
enum class Prediction {
  kConstantVelocity,
  kIdentity,  ///< the pose of the keyframe itself: the paper's
};

/// When a tracked frame becomes the new keyframe.
struct KeyframeOptions {
  double min_overlap = 0.8;
  double max_translation = 0.20;
  double max_rotation = 0.25;
};

/// When a registration is not believed.
struct LostOptions {
  int min_points = 50;
  double min_overlap = 0.3;
  double min_cos_theta = 0.1;
  double max_speed = 3.0;
  double max_angular_speed = 6.0;
  int restart_after = 10;
};

struct TrackerOptions {
  Reference reference = Reference::kKeyframe;
  Prediction prediction = Prediction::kConstantVelocity;
  int recovery_scales = 1;
  int points = 1500;
  int keyframe_points = 6000;
  bool compensate_depth_delay = true;
  bool compensate_rolling_shutter = true;
  bool compensate_exposure = true;
  int threads = 1;
  SelectionOptions selection;
  RegistrationOptions registration;
  KeyframeOptions keyframe;
  LostOptions lost;
};

[[nodiscard]] OptionSet describe(KeyframeOptions& options);
[[nodiscard]] OptionSet describe(LostOptions& options);
[[nodiscard]] OptionSet describe(TrackerOptions& options);

/// Throws OptionError where options that are each in range contradict one another.
void check_consistency(const TrackerOptions& options);

/// The paper's whole protocol: previous frame as reference, identity start, gradient flow, linear
/// colour kernel, edge points, and its table of constants.
[[nodiscard]] TrackerOptions paper_options();

}  // namespace cvo_slam
