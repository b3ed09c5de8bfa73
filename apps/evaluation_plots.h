// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cvo_slam/apps/evaluation_report.h"
#include "cvo_slam/core/trajectory.h"
#include "cvo_slam/plot/figure.h"

namespace cvo_slam {

/// A figure and the name of its files, without the ending.
struct NamedFigure {
  std::string name;
  Figure figure;
};

/// Returns the part of the reference within the time span of the estimate, or all of it if that
/// part is empty. `offset` [s] is the time to add to the stamps of the estimate.
[[nodiscard]] std::vector<StampedPose> reference_during(const std::vector<StampedPose>& reference,
                                                        const std::vector<StampedPose>& estimate,
                                                        double offset = 0);

/// Returns two figures: "trajectory" shows the aligned estimate against the reference, "errors" the
/// errors over time.
[[nodiscard]] std::vector<NamedFigure> evaluation_figures(const std::vector<StampedPose>& reference,
                                                          const std::vector<StampedPose>& estimate,
                                                          const EvaluationReport& report);

/// Writes each figure as PNG and as SVG into `folder`, which is made if it is missing. Throws
/// OutputError.
void write_figures(const std::filesystem::path& folder, const std::vector<NamedFigure>& figures);

}  // namespace cvo_slam
