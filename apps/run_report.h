// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "cvo_slam/apps/evaluation_report.h"
#include "cvo_slam/apps/loop_pictures.h"
#include "cvo_slam/apps/odometry_run.h"
#include "cvo_slam/apps/run_map.h"
#include "cvo_slam/apps/slam_run.h"
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

/// All figures, with the effective options.
[[nodiscard]] nlohmann::ordered_json to_json(const RunReport& report);

/// The table at the end of a run.
[[nodiscard]] std::string to_table(const RunReport& report);

/// One line a frame.
[[nodiscard]] std::string frames_csv(const OdometryRun& run);

/// Writes every file of a run into `folder`, which exists: trajectory.txt, trajectory_online.txt,
/// frames.csv, config.yaml, report.json, report.html, the plots, those of the map, of the graph and
/// of its loops. Says in the report's notes what is not in a picture. Throws OutputError.
void write_run(const std::filesystem::path& folder, RunReport& report);

}  // namespace cvo_slam
