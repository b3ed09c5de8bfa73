// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cvo_slam/frontend/objective_internal.h"

namespace cvo_slam {

/// Returns the objective of all points of a moving cloud at one pose.
inline ObjectiveValue evaluate(const Objective& objective, const PointCloud& moving,
                               const SE3& T_fixed_moving, const Executor& executor = Executor()) {
  PairTable pairs;
  return PoseObjective(objective, moving, moving.size(), pairs, executor).evaluate(T_fixed_moving);
}

}  // namespace cvo_slam
