// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "cvo_slam/apps/frame_pair.h"
#include "cvo_slam/apps/frame_registration.h"
#include "cvo_slam/frontend/registration.h"
#include "cvo_slam/plot/figure.h"

namespace cvo_slam {

/// Both frames' surfaces seen from one place before and after the registration, a in shades of blue
/// and b in shades of orange, each beside the sparsity pattern of the kernel matrix at the last
/// length scale.
[[nodiscard]] Figure registration_figure(const FramePair& pair,
                                         const FrameRegistration& registration,
                                         const KernelOptions& kernel);

/// Writes registration.{png,svg} and, of the first step of the flow at the first length scale,
/// step.{png,svg} into the folder, which is made where it is missing. Throws OutputError.
void write_registration_plots(const std::filesystem::path& folder, const FramePair& pair,
                              const FrameRegistration& registration,
                              const RegistrationOptions& options);

}  // namespace cvo_slam
