// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "cvo_slam/apps/odometry_run.h"
#include "cvo_slam/apps/tracking_arguments.h"
#include "cvo_slam/core/pose_graph.h"
#include "cvo_slam/core/trajectory.h"
#include "cvo_slam/io/dataset.h"
#include "cvo_slam/slam/slam.h"

namespace cvo_slam {

/// What the graph of a run came to.
struct GraphResult {
  PoseGraph graph;
  std::vector<Keyframe> keyframes;
  std::vector<LoopCandidate> candidates;
  GraphStatistics statistics;
};

struct SlamRun {
  OdometryRun run;        ///< with the online poses
  Trajectory trajectory;  ///< the final one
  GraphResult graph;
};

/// Runs the frames of a range through Slam; see run_frames. Null = the built-in vocabulary.
[[nodiscard]] SlamRun run_slam(const Dataset& data, const FrameRange& range,
                               const ProgramOptions& options,
                               const std::shared_ptr<const Vocabulary>& vocabulary,
                               const RunControl& control);

}  // namespace cvo_slam
