// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cvo_slam/core/absolute_trajectory_error.h"
#include "cvo_slam/core/association.h"
#include "cvo_slam/core/relative_pose_error.h"

namespace cvo_slam {

struct EvaluationOptions {
  AssociationOptions association = {};
  Alignment alignment = Alignment::kSe3;
  /// One RPE each. The default: drift over a second as the TUM benchmark defines it, and frame to
  /// frame.
  std::vector<RelativePoseOptions> relative = {{},
                                               {.unit = DeltaUnit::kFrames, .all_pairs = false}};
};

struct RelativeEvaluation {
  RelativePoseOptions options;
  std::optional<RelativePoseError> error;  ///< empty where no two poses are so far apart
};

/// What an estimate is worth against a reference.
struct EvaluationReport {
  EvaluationOptions options;
  std::size_t reference_poses = 0;
  std::size_t estimate_poses = 0;
  std::size_t matches = 0;
  double coverage = 0;  ///< matches by poses of the estimate (or of the reference if it has fewer)
  std::optional<AbsoluteTrajectoryError> ate;  ///< empty where the alignment is not unique
  std::vector<RelativeEvaluation> relative;    ///< in the order of the options
  std::vector<std::string> notes;              ///< why a figure is missing, a line each
};

/// ATE and RPE. With a sim3 alignment RPE is taken of the scaled estimate. A figure that does not
/// exist is left empty with a note; throws DataError where none does, OptionError for a bad option.
[[nodiscard]] EvaluationReport evaluate(const std::vector<StampedPose>& reference,
                                        const std::vector<StampedPose>& estimate,
                                        const EvaluationOptions& options = {});

/// "none", "se3" or "sim3", as on the command line.
[[nodiscard]] std::string_view name_of(Alignment alignment);

/// "RPE 1 s", "RPE 0.5 m", "RPE 1 frame": how tables and plots call a relative error.
[[nodiscard]] std::string label_of(const RelativePoseOptions& options);

/// All figures as lines of text for people, metres and degrees.
[[nodiscard]] std::string to_table(const EvaluationReport& report);

}  // namespace cvo_slam
