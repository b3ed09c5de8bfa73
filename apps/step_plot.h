// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cvo_slam/frontend/inspection.h"
#include "cvo_slam/plot/figure.h"

namespace cvo_slam {

/// The objective along a step of the gradient flow, exact and expanded to second and fourth order,
/// with the steps that the expansions choose.
[[nodiscard]] Figure step_figure(const StepCurve& curve);

}  // namespace cvo_slam
