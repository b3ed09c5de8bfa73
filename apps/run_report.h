// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cvo_slam/apps/depth_clock.h"
#include "cvo_slam/apps/evaluation_report.h"
#include "cvo_slam/apps/loop_pictures.h"
#include "cvo_slam/apps/run_map.h"
#include "cvo_slam/apps/sequence_run.h"
#include "cvo_slam/apps/tracking_arguments.h"

namespace cvo_slam {

/// All results of a run.
struct RunReport {
  const Dataset& data;
  DepthClock clock;
  FrameRange range;
  ProgramOptions options;
  std::string mode;
  OdometryRun run;
  std::optional<GraphResult> graph;  ///< empty in mode odometry
  RunMap map;
  Trajectory trajectory;
  std::optional<EvaluationReport> evaluation;
  std::vector<std::string> notes;
  LoopPictures loop_pictures = LoopPictures::kAccepted;

  std::optional<Map> saved_map = std::nullopt;   ///< to be written into the folder map
  std::optional<MapUse> map_use = std::nullopt;  ///< of a map that the run started from

  /// Returns the share of frames without a pose in the trajectory, 0 to 1. With a map that is only
  /// used to locate frames, those that were tracked outside it are not lost.
  [[nodiscard]] double lost_share() const;
  /// Number of frames with a pose in the map that the run started from.
  [[nodiscard]] std::size_t localized_frames() const;
  /// Returns the notes, with the notes and warnings of the evaluation.
  [[nodiscard]] std::vector<std::string> all_notes() const;
};

/// Returns the median of a cost over the frames of a run [ms].
[[nodiscard]] double median_cost(const OdometryRun& run, double FrameCost::*cost);

/// Returns the table at the end of a run.
[[nodiscard]] std::string to_table(const RunReport& report);

/// Returns the text of frames.csv: a header, and one line for each frame.
[[nodiscard]] std::string frames_csv(const OdometryRun& run);

}  // namespace cvo_slam
