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

/// The part of the reference from the estimate's begin to its end; all of it where that is empty.
/// `offset` [s] is what leads from the estimate's stamps to the reference's.
[[nodiscard]] std::vector<StampedPose> reference_during(const std::vector<StampedPose>& reference,
                                                        const std::vector<StampedPose>& estimate,
                                                        double offset = 0);

/// "trajectory", the aligned estimate against the reference, and "errors", the errors over time.
[[nodiscard]] std::vector<NamedFigure> evaluation_figures(const std::vector<StampedPose>& reference,
                                                          const std::vector<StampedPose>& estimate,
                                                          const EvaluationReport& report);

/// Writes each figure as PNG and as SVG into `folder`, which is made where it is missing. Throws
/// OutputError.
void write_figures(const std::filesystem::path& folder, const std::vector<NamedFigure>& figures);

}  // namespace cvo_slam
