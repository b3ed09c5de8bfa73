// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

#include "cvo_slam/apps/evaluation_report.h"
#include "cvo_slam/core/trajectory.h"

namespace cvo_slam {

/// Writes trajectory.{png,svg}, the aligned estimate against the reference, and errors.{png,svg},
/// the errors over time, into `folder`, which is made where it is missing. Throws OutputError.
void write_evaluation_plots(const std::filesystem::path& folder,
                            const std::vector<StampedPose>& reference,
                            const std::vector<StampedPose>& estimate,
                            const EvaluationReport& report);

/// Writes trajectory.{png,svg} of an estimate without a reference. Throws OutputError.
void write_trajectory_plot(const std::filesystem::path& folder,
                           const std::vector<StampedPose>& estimate);

}  // namespace cvo_slam
