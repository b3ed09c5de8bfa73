// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cvo_slam/apps/argument_text.h"
#include "cvo_slam/apps/evaluation_report.h"
#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/rgbd_frame.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/core/statistics.h"
#include "cvo_slam/core/trajectory.h"
#include "cvo_slam/frontend/tracker_options.h"
#include "cvo_slam/io/dataset.h"

namespace cvo_slam {

/// An RGB-D odometry as `bench odometry` sees it.
class OdometrySystem {
 public:
  virtual ~OdometrySystem() = default;

  /// T_world_camera of the next frame; empty where the system lost it.
  [[nodiscard]] virtual std::optional<SE3> track(const RgbdFrame& frame) = 0;
};

/// One of the systems to compare.
struct Contestant {
  std::string name;                        ///< as in --systems
  std::string description;                 ///< for people
  std::unique_ptr<OdometrySystem> system;  ///< null where it is not built in
};

/// The names of all systems, in the order of the table.
[[nodiscard]] std::vector<std::string> odometry_system_names();

/// The systems of these names; `options` are for "ours" alone.
/// Throws OptionError for an unknown name (the message gives the nearest) or a bad option.
[[nodiscard]] std::vector<Contestant> make_contestants(const std::vector<std::string>& names,
                                                       const Camera& camera,
                                                       const TrackerOptions& options);

/// How one system did.
struct ContestantResult {
  std::string name;
  std::string description;
  bool built_in = true;                        ///< if not, nothing below says anything
  std::size_t lost = 0;                        ///< frames without a pose of their own
  std::vector<StampedPose> poses;              ///< one a frame: a lost one keeps the pose before it
  Statistics cpu;                              ///< CPU time of the calling thread a frame [s]
  std::optional<EvaluationReport> evaluation;  ///< empty without a reference it can be held against
};

struct OdometryBenchmark {
  FrameRange frames;
  Statistics decoding;  ///< CPU time of reading a frame, which is in no system's time [s]
  std::vector<ContestantResult> results;
};

/// Called with the number of frames done and their total.
using BenchmarkProgress = std::function<void(std::size_t done, std::size_t total)>;

/// Hands every frame to every system in turn, so that whatever else the machine does slows all of
/// them alike. Everything a system does must happen in the calling thread, or its time is not seen.
/// Every system is judged on every frame: losing some does not make its figures better.
[[nodiscard]] OdometryBenchmark run_odometry_benchmark(const Dataset& data,
                                                       const FrameRange& frames,
                                                       const std::vector<Contestant>& contestants,
                                                       const BenchmarkProgress& progress = {});

}  // namespace cvo_slam
