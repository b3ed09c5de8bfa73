// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cvo_slam/backend/optimizer.h"
#include "cvo_slam/core/options.h"
#include "cvo_slam/loop/loop_detector.h"

namespace cvo_slam {

/// Where the work on the map is done.
enum class Schedule {
  kInline,     ///< within track()
  kPipelined,  ///< in a thread of its own, while the next frames are tracked
};

/// How a keyframe is registered to an earlier one, and when the answer is believed.
struct PairOptions {
  int points = 1500;
  int skip_scales = 1;
  double min_overlap = 0.6;
  double min_cos_theta = 0.4;
  double max_round_trip_translation = 0.01;
  double max_round_trip_rotation = 0.015;
  double max_error = 8;
};

/// Which earlier keyframes a new one is registered to besides its predecessor.
struct ProximityOptions {
  int recent = 4;
  int near = 4;
  int min_gap = 5;
  double min_expected_overlap = 0.6;
  PairOptions pair = {};
};

/// What it takes to believe in a place where the graph cannot say whether the camera can be there:
/// when tracking is lost, and to join parts of the graph.
struct RelocalizationOptions {
  double min_likely_coverage = 0.6;
  double min_likeness = 3.2;
  double lost_speed = 1.5;
  double lost_angular_speed = 1;
  double rival_share = 0.9;
  int frames = 3;
  int join_keyframes = 3;
  double max_disagreement_translation = 0.2;
  double max_disagreement_rotation = 0.1;
};

/// Whether and how places that were seen before are recognised by their images.
struct LoopClosingOptions {
  bool enabled = false;
  LoopOptions detection;
  PairOptions pair = {.skip_scales = 0,
                      .min_overlap = 0.5,
                      .max_round_trip_translation = 0.02,
                      .max_round_trip_rotation = 0.02};
  double max_residual = 8;
  RelocalizationOptions relocalization;
};

struct SlamOptions {
  Schedule schedule = Schedule::kInline;
  int correction_delay = 2;
  int optimize_every = 5;
  double noise_translation = 0.004;
  double noise_rotation = 0.004;
  ProximityOptions proximity;
  LoopClosingOptions loops;
  OptimizerOptions optimizer = {.loss = RobustLoss::kCauchy};
};

[[nodiscard]] OptionSet describe(PairOptions& options);
[[nodiscard]] OptionSet describe(ProximityOptions& options);
[[nodiscard]] OptionSet describe(RelocalizationOptions& options);
[[nodiscard]] OptionSet describe(LoopClosingOptions& options);
[[nodiscard]] OptionSet describe(SlamOptions& options);

}  // namespace cvo_slam
