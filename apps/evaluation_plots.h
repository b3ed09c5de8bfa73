// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

#include "cvo_slam/apps/evaluation_report.h"
#include "cvo_slam/core/trajectory.h"
#include "cvo_slam/io/plot/figure.h"

namespace cvo_slam {

/// Writes <stem>.png and <stem>.svg. Throws OutputError.
void write_figure(const std::filesystem::path& stem, const Figure& figure);

/// The part of the reference from the estimate's begin to its end; all of it where that is empty.
/// `offset` [s] is what leads from the estimate's stamps to the reference's.
[[nodiscard]] std::vector<StampedPose> reference_during(const std::vector<StampedPose>& reference,
                                                        const std::vector<StampedPose>& estimate,
                                                        double offset = 0);

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
