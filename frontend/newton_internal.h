// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cvo_slam/frontend/objective_internal.h"
#include "cvo_slam/frontend/registration.h"

namespace cvo_slam {

/// How a search at one length scale ended.
struct LevelResult {
  SE3 T_fixed_moving;
  ObjectiveValue value;  ///< at T_fixed_moving
  int iterations = 0;
  bool converged = false;
};

/// When a search at one length scale ends.
struct StopRule {
  int max_iterations = 10;
  double translation = 1e-4;  ///< of a step [m]
  double rotation = 1e-4;     ///< of a step [rad]
  /// With the last step, whose end is then not evaluated, or before it. A search that a finer one
  /// follows needs no proof of its end.
  bool take_last_step = false;
};

/// Maximises the objective at its length scale from a start by Newton steps; every accepted step
/// raises ObjectiveValue::value.
[[nodiscard]] LevelResult newton(PoseObjective& objective, const SE3& T_fixed_moving_init,
                                 const StopRule& stop);

}  // namespace cvo_slam
