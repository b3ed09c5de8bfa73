// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/pose_graph.h"
#include "cvo_slam/core/rgbd_frame.h"
#include "cvo_slam/core/trajectory.h"
#include "cvo_slam/frontend/tracker.h"
#include "cvo_slam/loop/vocabulary.h"
#include "cvo_slam/slam/graph_statistics.h"
#include "cvo_slam/slam/loop_candidate.h"
#include "cvo_slam/slam/slam_options.h"

namespace cvo_slam {

enum class TrajectoryView {
  kFinal,   ///< every frame as the graph has its keyframe now
  kOnline,  ///< what track() answered at the time
};

/// A keyframe as the graph has it.
struct Keyframe {
  std::size_t frame = 0;  ///< RgbdFrame::index
  Timestamp stamp;
  int segment = 0;  ///< poses of different ones are of different worlds
  SE3 T_world_camera;
};

/// Tracks an RGB-D camera and keeps a graph of its keyframes, in which many registrations between
/// near ones hold the drift down and, where SlamOptions::loops are enabled, places that are
/// recognised take it out.
///
///   Slam slam(camera);
///   while (...) slam.track(frame);
///   slam.finish();
///   write_tum("trajectory.txt", slam.trajectory());
///
/// Where loops are enabled a lost camera is looked for among the keyframes: when a few frames in a
/// row agree on where it is, it goes on from there. Else a new segment starts after a while, as the
/// tracker's options say, in a world of its own, and is joined when enough of its keyframes say
/// where it is. Segments that are joined are one: FrameRecord::submap is then the first of them.
///
/// Results do not depend on threads, schedule or timing. Until finish() what the functions below
/// answer is of the keyframes that the map knows so far; they wait for work that is under way.
class Slam {
 public:
  /// Throws OptionError where the camera or an option is impossible. The vocabulary is for loops;
  /// without one they use the built-in one.
  explicit Slam(const Camera& camera, const TrackerOptions& tracker = {},
                const SlamOptions& options = {},
                const std::shared_ptr<const Vocabulary>& vocabulary = nullptr);
  ~Slam();
  Slam(Slam&& other) noexcept;
  Slam& operator=(Slam&& other) noexcept;

  /// Tracks the next frame. Never throws on a bad image: the answer is kLost with a reason. So is
  /// that to a frame whose index is not larger than that of the frame before. T_world_camera has
  /// what the graph has learnt until SlamOptions::correction_delay keyframes ago.
  FrameRecord track(const RgbdFrame& frame);

  /// Optimises the whole graph. May be called again; tracking may go on after it.
  void finish();

  /// The camera's path: of the segment with most frames, after joining; those of others are lost.
  [[nodiscard]] Trajectory trajectory(TrajectoryView view = TrajectoryView::kFinal) const;
  /// Nodes are keyframes; their ids are the indices of the frames.
  [[nodiscard]] PoseGraph pose_graph() const;
  [[nodiscard]] std::vector<Keyframe> keyframes() const;
  /// Every pair that was tried, with the verdict.
  [[nodiscard]] std::vector<LoopCandidate> loop_candidates() const;
  [[nodiscard]] GraphStatistics graph_statistics() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace cvo_slam
