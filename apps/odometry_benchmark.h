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
#include "cvo_slam/apps/odometry_benchmark.h"
#include "cvo_slam/apps/tracking_arguments.h"
#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/rgbd_frame.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/core/trajectory.h"
#include "cvo_slam/core/trajectory_errors.h"
#include "cvo_slam/frontend/tracker.h"
#include "cvo_slam/io/dataset.h"

namespace cvo_slam {

/// A system that `bench` can run.
class OdometrySystem {
 public:
  OdometrySystem() = default;
  OdometrySystem(const OdometrySystem&) = delete;
  OdometrySystem& operator=(const OdometrySystem&) = delete;
  virtual ~OdometrySystem() = default;

  /// Returns T_world_camera of the next frame, or nothing if the system lost it.
  [[nodiscard]] virtual std::optional<SE3> track(const RgbdFrame& frame) = 0;

  /// Ends the sequence. Returns the whole path if the system knows more of it now than when it
  /// tracked; frames that it has no pose for are not in it, and count as lost.
  [[nodiscard]] virtual std::optional<Trajectory> finish() { return std::nullopt; }

  /// Returns for how many frames it has looked for a start by features; empty if that is not
  /// counted.
  [[nodiscard]] virtual std::optional<std::size_t> features_asked() const { return std::nullopt; }
};

/// One of the systems to compare.
struct Contestant {
  std::string name;                        ///< as in --systems
  std::string description;                 ///< one line for people
  std::unique_ptr<OdometrySystem> system;  ///< null if it is not built in
};

/// Returns the names of all systems, in the order of the table.
[[nodiscard]] std::vector<std::string> odometry_system_names();

/// Makes the systems with these names; only "ours" uses `options`.
/// Throws OptionError for an unknown name (the message gives the nearest) or a bad option.
[[nodiscard]] std::vector<Contestant> make_contestants(const std::vector<std::string>& names,
                                                       const Camera& camera,
                                                       const TrackerOptions& options);

/// Our tracker as a system.
[[nodiscard]] std::unique_ptr<OdometrySystem> make_tracker_system(const Camera& camera,
                                                                  const TrackerOptions& options);

/// The tracked frames whose poses are wrong, as find_wrong_poses() says.
struct WrongFrames {
  std::size_t checked = 0;        ///< number of tracked frames whose true pose is known
  std::vector<PoseError> frames;  ///< those of them that are wrong
};

/// The result of one system.
struct ContestantResult {
  std::string name;
  std::string description;
  bool built_in = true;              ///< if false, the members below have no meaning
  std::size_t lost = 0;              ///< number of frames without a pose of their own
  std::vector<StampedPose> poses;    ///< one for each frame; a lost frame repeats the last pose
  std::optional<WrongFrames> wrong;  ///< empty without a usable reference
  std::optional<std::size_t> features_asked;   ///< OdometrySystem::features_asked()
  Statistics cpu;                              ///< CPU time of the calling thread for a frame [s]
  double finish_cpu = 0;                       ///< CPU time of the work after the last frame [s]
  std::optional<EvaluationReport> evaluation;  ///< empty without a usable reference
};

struct OdometryBenchmark {
  FrameRange frames;
  std::string depth_offset;  ///< that the sequence was read with, for people; may be empty
  Statistics decoding;       ///< CPU time of reading a frame, which no system is charged [s]
  std::vector<ContestantResult> results;
};

/// Called with the number of frames done and their total.
using BenchmarkProgress = std::function<void(std::size_t done, std::size_t total)>;

/// Gives every frame to every system in turn, so that other work of the machine slows all of them
/// alike. A system must do its work in the calling thread, because only the time of that thread is
/// measured. Every system is judged on every frame: losing frames does not make its figures better.
[[nodiscard]] OdometryBenchmark run_odometry_benchmark(const Dataset& data,
                                                       const FrameRange& frames,
                                                       const std::vector<Contestant>& contestants,
                                                       const BenchmarkProgress& progress = {});

}  // namespace cvo_slam
