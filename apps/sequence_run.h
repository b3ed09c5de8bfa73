// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Running a sequence through the tracker or through Slam.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cvo_slam/apps/argument_text.h"
#include "cvo_slam/apps/evaluation_report.h"
#include "cvo_slam/apps/tracking_arguments.h"
#include "cvo_slam/core/map.h"
#include "cvo_slam/core/pose_graph.h"
#include "cvo_slam/core/trajectory.h"
#include "cvo_slam/frontend/tracker.h"
#include "cvo_slam/io/dataset.h"
#include "cvo_slam/slam/slam.h"

namespace cvo_slam {

/// Catches SIGINT and SIGTERM for as long as it lives, so that a run can end early and still write
/// what there is. A second such signal ends the program at once. There may be one guard at a time.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  /// The signal that arrived; 0 if none did.
  [[nodiscard]] static int signal();
  [[nodiscard]] static bool requested() { return signal() != 0; }

 private:
  void (*previous_interrupt_)(int);
  void (*previous_termination_)(int);
};

/// Wall time of one frame.
struct FrameCost {
  double read_ms = 0;   ///< time of waiting for the images, which are decoded ahead
  double track_ms = 0;  ///< time of tracking
};

/// The map that a run starts from.
struct LoadedMap {
  Map map;  ///< with the camera of the sequence
  MapUse use = MapUse::kExtend;

  /// Number of the keyframe that the frame with the index 0 would be.
  [[nodiscard]] std::size_t first_number() const;
};

/// How a run goes, whatever its tracker.
struct RunControl {
  bool quiet = false;  ///< show no progress
  /// Distance between the pixels of a keyframe that are kept for a map (core/point_fusion.h) [px];
  /// 0 = keep none.
  int kept_pixel_step = 0;
  bool keep_map = false;  ///< return the map of a SlamRun
};

/// What a MB of memory is in reports.
inline constexpr double kBytesOfMegabyte = 1024.0 * 1024;

/// CPU time of the process so far [s].
[[nodiscard]] double process_cpu_seconds();

/// A sequence as a tracker went through it.
struct OdometryRun {
  std::vector<FrameRecord> records;
  std::vector<FrameCost> costs;  ///< one for each record
  std::vector<SampledFrame> kept_keyframes;
  double seconds = 0;         ///< wall time of all frames, and of the work after the last one
  double cpu_seconds = 0;     ///< CPU time of the process meanwhile
  double peak_memory_mb = 0;  ///< peak memory of the process so far
  int signal = 0;             ///< that ended the run early (SIGINT, SIGTERM); 0 if none did
  /// True if the run ended after its first frames because none of their images could be used.
  bool unusable = false;

  [[nodiscard]] std::size_t keyframes() const;
  [[nodiscard]] double fps() const;
};

/// The pose graph of a run and how it came about.
struct GraphResult {
  PoseGraph graph;
  std::vector<Keyframe> keyframes;
  std::vector<LoopCandidate> candidates;
  GraphStatistics statistics;
  std::size_t first_number = 0;  ///< of a keyframe with the frame index 0; smaller ones were loaded
};

/// A sequence as Slam went through it.
struct SlamRun {
  OdometryRun run;        ///< has the online poses
  Trajectory trajectory;  ///< the final one
  GraphResult graph;
  std::optional<Map> map;  ///< if it was asked for
};

/// The frames of a sequence, one after the other.
struct FrameStream {
  FrameSource& frames;
  const Camera& camera;
  std::size_t count = 0;  ///< number of frames; 0 if it is not known
};

/// Runs frames through the tracker alone. Ends early, with what there is, if the user interrupts
/// (SIGINT, SIGTERM) while an InterruptGuard lives, and if none of the first ten frames has images
/// that can be used.
[[nodiscard]] OdometryRun run_odometry(const FrameStream& stream, const TrackerOptions& options,
                                       const RunControl& control);

/// Runs frames through Slam, and ends early in the same way. A null vocabulary means the built-in
/// one; with `loaded`, the run goes on from that map.
[[nodiscard]] SlamRun run_slam(const FrameStream& stream, const ProgramOptions& options,
                               const std::shared_ptr<const Vocabulary>& vocabulary,
                               const RunControl& control,
                               const std::optional<LoadedMap>& loaded = std::nullopt);

/// Returns a warning if a few frames re-project badly into each other by the reference, or by the
/// estimate if there is none.
[[nodiscard]] std::optional<std::string> agreement_warning(const Dataset& data,
                                                           const Trajectory& trajectory);

/// Returns the errors against the sequence's reference; nothing if there is no reference or nothing
/// to compare, with a line in `notes` that says why.
[[nodiscard]] std::optional<EvaluationReport> evaluate_run(const Dataset& data,
                                                           const Trajectory& trajectory,
                                                           std::vector<std::string>& notes);

}  // namespace cvo_slam
