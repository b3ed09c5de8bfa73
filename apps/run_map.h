// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "cvo_slam/apps/sequence_run.h"
#include "cvo_slam/core/map.h"

namespace cvo_slam {

/// The map of a run.
struct RunMap {
  Map map;
  bool has_points = false;  ///< true if points were asked for
  double cpu_seconds = 0;   ///< CPU time of the process for the points and their picture
  std::string renderer;     ///< the renderer that drew the picture; empty if there is none
};

/// Makes the map of a run: its keyframes, its graph, and the points of the keyframes that it kept.
/// Keyframes without a pose in the trajectory add no points.
[[nodiscard]] RunMap make_run_map(const OdometryRun& run, const std::optional<GraphResult>& graph,
                                  const Trajectory& trajectory, const Camera& camera,
                                  const FusionOptions& options, int threads);

/// Writes the files of the map and, if points were asked for, map.png: the points with the path and
/// the reference fitted to it. Returns the picture (CV_8UC3), which is empty if there is none. Adds
/// to `notes` what the picture lacks. Throws OutputError.
cv::Mat write_run_map(const std::filesystem::path& folder, RunMap& run_map,
                      const Trajectory& trajectory, const std::vector<StampedPose>& reference,
                      std::vector<std::string>& notes);

}  // namespace cvo_slam
