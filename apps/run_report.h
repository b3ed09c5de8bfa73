// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cvo_slam/apps/evaluation_report.h"
#include "cvo_slam/apps/loop_pictures.h"
#include "cvo_slam/apps/sequence_run.h"
#include "cvo_slam/apps/run_map.h"
#include "cvo_slam/apps/tracking_arguments.h"

namespace cvo_slam {

/// All that a run leaves behind.
struct RunReport {
  const Dataset& data;
  FrameRange range;
  ProgramOptions options;
  std::string mode;
  OdometryRun run;
  std::optional<GraphResult> graph;  ///< of the modes that have one
  RunMap map;
  Trajectory trajectory;
  std::optional<EvaluationReport> evaluation;
  std::vector<std::string> notes;
  LoopPictures loop_pictures = LoopPictures::kAccepted;

  /// Frames without a pose in the trajectory by all frames.
  [[nodiscard]] double lost_share() const;
};

/// Median of a cost over the frames of a run [ms].
[[nodiscard]] double median_cost(const OdometryRun& run, double FrameCost::*cost);

/// The table at the end of a run.
[[nodiscard]] std::string to_table(const RunReport& report);

/// One line a frame.
[[nodiscard]] std::string frames_csv(const OdometryRun& run);

}  // namespace cvo_slam
