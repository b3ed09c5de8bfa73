// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cvo_slam/backend/optimizer_options.h"
#include "cvo_slam/core/options.h"

namespace cvo_slam {

/// Where the work on the map is done.
enum class Schedule {
  kInline,     ///< within track()
  kPipelined,  ///< in a thread of its own, while the next frames are tracked
};

/// Which earlier keyframes a new one is registered to besides its predecessor, and when the answer
/// is believed.
struct ProximityOptions {
  int recent = 4;
  int near = 4;
  int min_gap = 5;
  int points = 1500;
  int skip_scales = 1;
  double min_expected_overlap = 0.6;
  double min_overlap = 0.6;
  double min_cos_theta = 0.4;
  double max_round_trip_translation = 0.01;
  double max_round_trip_rotation = 0.015;
  double max_error = 8;
};

struct SlamOptions {
  Schedule schedule = Schedule::kInline;
  int correction_delay = 2;
  int optimize_every = 5;
  double noise_translation = 0.004;
  double noise_rotation = 0.004;
  ProximityOptions proximity;
  OptimizerOptions optimizer = {.loss = RobustLoss::kCauchy};
};

[[nodiscard]] OptionSet describe(ProximityOptions& options);
[[nodiscard]] OptionSet describe(SlamOptions& options);

}  // namespace cvo_slam
