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

/// Maximises the objective at its length scale from a start by Newton steps; every accepted step
/// raises ObjectiveValue::value.
[[nodiscard]] LevelResult newton(const Objective& objective, const PointCloud& moving,
                                 const SE3& T_fixed_moving_init, int max_iterations,
                                 const RegistrationOptions& options, const Executor& executor);

}  // namespace cvo_slam
