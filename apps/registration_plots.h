// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "cvo_slam/apps/frame_pair.h"
#include "cvo_slam/apps/frame_registration.h"
#include "cvo_slam/frontend/inspection.h"
#include "cvo_slam/frontend/registration.h"
#include "cvo_slam/plot/figure.h"

namespace cvo_slam {

/// The objective along a step of the gradient flow, exact and expanded to second and fourth order,
/// with the steps that the expansions choose.
[[nodiscard]] Figure step_figure(const StepCurve& curve);

/// Writes two figures into the folder, which is made if it is missing. registration.{png,svg}: both
/// frames before and after, and the sparsity pattern of the kernel matrix. step.{png,svg}: the
/// objective along the first step of the flow at the first length scale. Throws OutputError.
void write_registration_plots(const std::filesystem::path& folder, const FramePair& pair,
                              const FrameRegistration& registration,
                              const RegistrationOptions& options);

}  // namespace cvo_slam
