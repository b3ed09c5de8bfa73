// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "cvo_slam/core/association.h"
#include "cvo_slam/core/trajectory_errors.h"
#include "cvo_slam/io/trajectory_files.h"

namespace cvo_slam {

struct EvaluationOptions {
  AssociationOptions association = {};
  Alignment alignment = Alignment::kSe3;
  /// The relative errors to compute. The default is the drift over a second as the TUM benchmark
  /// defines it, and the error from frame to frame.
  std::vector<RelativePoseOptions> relative = {{},
                                               {.unit = DeltaUnit::kFrames, .all_pairs = false}};
};

struct RelativeEvaluation {
  RelativePoseOptions options;
  std::optional<RelativePoseError> error;  ///< empty if no two poses are so far apart
};

/// The lines of both files that were left out when they were read.
struct LeftOutOfFiles {
  LeftOutLines reference = {};
  LeftOutLines estimate = {};
};

/// The errors of an estimate against a reference.
struct EvaluationReport {
  EvaluationOptions options;
  std::size_t reference_poses = 0;  ///< with those that were left out
  std::size_t estimate_poses = 0;   ///< with those that were left out
  LeftOutOfFiles left_out;
  std::size_t matches = 0;
  std::size_t unmatched = 0;  ///< poses of the estimate without a partner, besides those left out
  double coverage = 0;  ///< matches / poses of the estimate, or of the reference if it has fewer
  std::optional<AbsoluteTrajectoryError> ate;  ///< empty if the alignment is not unique
  std::vector<RelativeEvaluation> relative;    ///< in the order of the options
  std::vector<std::string> notes;              ///< one line for each missing figure: why
  /// One line for each large share of poses that is in no figure.
  std::vector<std::string> warnings;
  /// The same with the measured offset between the clocks; empty if it was not asked for.
  std::shared_ptr<const EvaluationReport> at_best_offset;
};

/// Computes ATE and RPE. With a sim3 alignment the RPE is that of the scaled estimate. A figure
/// that does not exist is left empty, with a note. Lines that were left out of the files count as
/// poses that were not matched. Throws DataError if no figure exists, OptionError for a bad option.
[[nodiscard]] EvaluationReport evaluate(const std::vector<StampedPose>& reference,
                                        const std::vector<StampedPose>& estimate,
                                        const EvaluationOptions& options = {},
                                        const LeftOutOfFiles& left_out = {});

/// Returns "none", "se3" or "sim3", as on the command line.
[[nodiscard]] std::string_view name_of(Alignment alignment);

/// Returns the name of a relative error in tables and plots: "RPE 1 s", "RPE 0.5 m", "RPE 1 frame".
[[nodiscard]] std::string label_of(const RelativePoseOptions& options);

/// Returns all figures as lines of text for people, in metres and degrees. Columns are as wide as
/// their widest number.
[[nodiscard]] std::string to_table(const EvaluationReport& report);

}  // namespace cvo_slam
