// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "cvo_slam/apps/evaluation_report.h"
#include "cvo_slam/apps/tracking_arguments.h"
#include "cvo_slam/core/map.h"
#include "cvo_slam/core/trajectory.h"
#include "cvo_slam/frontend/tracker.h"
#include "cvo_slam/io/dataset.h"

namespace cvo_slam {

/// What a frame cost.
struct FrameCost {
  double read_ms = 0;   ///< waiting for the images, which are decoded ahead
  double track_ms = 0;  ///< tracking it
};

/// How a run goes, whatever its tracker.
struct RunControl {
  bool quiet = false;  ///< no progress
  /// Every which pixel of a keyframe is kept for a map (core/map.h); 0 = none.
  int kept_pixel_step = 0;
};

/// CPU time of the process so far [s].
[[nodiscard]] double process_cpu_seconds();

/// A sequence as a tracker went through it.
struct OdometryRun {
  std::vector<FrameRecord> records;
  std::vector<FrameCost> costs;  ///< of each record
  std::vector<SampledFrame> kept_keyframes;
  double seconds = 0;         ///< wall time of all frames, and of what comes after the last
  double cpu_seconds = 0;     ///< of the process, likewise
  double peak_memory_mb = 0;  ///< of the process so far
  bool interrupted = false;

  [[nodiscard]] std::size_t keyframes() const;
  [[nodiscard]] double fps() const;
};

/// Gives the frames of a range to `track`, and calls `finish` after the last. Ends early, with what
/// there is, where the user interrupts (SIGINT) while an InterruptGuard lives.
[[nodiscard]] OdometryRun run_frames(const Dataset& data, const FrameRange& range,
                                     const std::function<FrameRecord(const RgbdFrame&)>& track,
                                     const std::function<void()>& finish,
                                     const RunControl& control);

/// The frames of a range in the tracker alone.
[[nodiscard]] OdometryRun run_odometry(const Dataset& data, const FrameRange& range,
                                       const TrackerOptions& options, const RunControl& control);

/// Errors against the sequence's reference; empty where there is none or nothing to compare, with a
/// line in `notes` that says why.
[[nodiscard]] std::optional<EvaluationReport> evaluate_run(const Dataset& data,
                                                           const Trajectory& trajectory,
                                                           std::vector<std::string>& notes);

}  // namespace cvo_slam
