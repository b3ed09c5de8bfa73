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
#include "cvo_slam/core/point_fusion.h"

namespace cvo_slam {

/// The map of a run.
struct RunMap {
  Map map;
  bool has_points = false;  ///< whether any were asked for
  double cpu_seconds = 0;   ///< of the process, for the points and their picture
  std::string renderer;     ///< that drew the picture; empty before
};

/// Keyframes and graph of a run and, of the keyframes that it has kept, the points; those of
/// keyframes that have no pose in the trajectory are left out.
[[nodiscard]] RunMap make_run_map(const OdometryRun& run, const std::optional<GraphResult>& graph,
                                  const Trajectory& trajectory, const Camera& camera,
                                  const FusionOptions& options, int threads);

/// Writes the map's files and, where points were asked for, map.png: the points with the path,
/// which is fitted to the reference where there is one. Answers the picture, CV_8UC3; empty where
/// there is none. Throws OutputError; what the picture lacks is said in `notes`.
cv::Mat write_run_map(const std::filesystem::path& folder, RunMap& run_map,
                      const Trajectory& trajectory, const std::vector<StampedPose>& reference,
                      std::vector<std::string>& notes);

}  // namespace cvo_slam
