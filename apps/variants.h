// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Our system, run several times with options that differ a little: a deterministic run is one
// sample of what a recording allows.
#pragma once

#include <string>
#include <vector>

#include "cvo_slam/apps/odometry_benchmark.h"
#include "cvo_slam/apps/tracking_arguments.h"
#include "cvo_slam/core/camera.h"

namespace cvo_slam {

/// Returns the names of the variants: "defaults" (the options as given), and the perturbations,
/// which change an option by so little that nothing speaks for either value.
[[nodiscard]] std::vector<std::string> variant_names();

/// Makes the variants with these names, to run in a mode of `cvo_slam run`: "odometry", "graph" or
/// "slam". Throws OptionError for an unknown name (the message gives the nearest) or a bad option.
[[nodiscard]] std::vector<Contestant> make_variants(const std::vector<std::string>& names,
                                                    const std::string& mode, const Camera& camera,
                                                    const ProgramOptions& options);

}  // namespace cvo_slam
