// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "cvo_slam/apps/evaluation_report.h"
#include "cvo_slam/apps/tracking_arguments.h"
#include "cvo_slam/core/trajectory.h"
#include "cvo_slam/frontend/tracker.h"
#include "cvo_slam/io/dataset.h"

namespace cvo_slam {

/// What a frame cost.
struct FrameCost {
  double read_ms = 0;   ///< waiting for the images, which are decoded ahead
  double track_ms = 0;  ///< Tracker::track()
};

/// A sequence as the tracker went through it.
struct OdometryRun {
  std::vector<FrameRecord> records;
  std::vector<FrameCost> costs;  ///< of each record
  double seconds = 0;            ///< wall time of all frames
  double cpu_seconds = 0;        ///< of the process, over all frames
  double peak_memory_mb = 0;     ///< of the process so far
  bool interrupted = false;

  [[nodiscard]] std::size_t keyframes() const;
  [[nodiscard]] double fps() const;
};

/// Tracks the frames of a range. Ends early, with what there is, where the user interrupts (SIGINT)
/// while an InterruptGuard lives.
[[nodiscard]] OdometryRun run_odometry(const Dataset& data, const FrameRange& range,
                                       const TrackerOptions& options, bool quiet);

/// Errors against the sequence's reference; empty where there is none or nothing to compare, with a
/// line in `notes` that says why.
[[nodiscard]] std::optional<EvaluationReport> evaluate_run(const Dataset& data,
                                                           const Trajectory& trajectory,
                                                           std::vector<std::string>& notes);

}  // namespace cvo_slam
