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
#include "cvo_slam/slam/loop_candidate.h"
#include "cvo_slam/slam/slam_options.h"

namespace cvo_slam {

enum class TrajectoryView {
  /// Every frame as the graph has its keyframe now.
  kFinal,
  /// The same with the poses and submaps that track() answered: those of the submap with most
  /// frames.
  kOnline,
};

/// A keyframe of the map.
struct Keyframe {
  std::size_t number = 0;  ///< RgbdFrame::index of its frame; files and edges name it so
  Timestamp stamp;
  int submap = 0;  ///< poses of different submaps are of different worlds
  SE3 T_world_camera;
};

/// Tracks an RGB-D camera and builds a map of keyframes. Registrations between near keyframes hold
/// the drift down, and keyframes that are recognised by their images take it out (loops).
///
///   Slam slam(camera);
///   while (grab(frame)) slam.track(frame);
///   slam.finish();
///   write_tum("trajectory.txt", slam.trajectory());
///
/// A lost camera is searched for among the keyframes; when a few frames in a row agree on where it
/// is, tracking goes on from there. Otherwise a new submap starts after a while (LostOptions), in a
/// world of its own, and is joined with another one when enough of its keyframes say how. Joined
/// submaps share the name of the first of them.
///
/// Results do not depend on the number of threads, the schedule or timing. Until finish() the
/// functions below answer for the keyframes that the map has so far; they wait for work that is
/// under way.
class Slam {
 public:
  /// Throws OptionError if the camera or an option is impossible. Loops use the built-in vocabulary
  /// if `vocabulary` is null.
  explicit Slam(const Camera& camera, const SlamOptions& options = {},
                const std::shared_ptr<const Vocabulary>& vocabulary = nullptr);
  ~Slam();
  Slam(Slam&& other) noexcept;
  Slam& operator=(Slam&& other) noexcept;

  /// Tracks the next frame. A bad image does not throw: the answer is kLost with a reason.
  /// T_world_camera contains the corrections that the map has computed up to
  /// SlamOptions::correction_delay keyframes ago. Throws DataError if RgbdFrame::index is not above
  /// that of the frame before.
  FrameRecord track(const RgbdFrame& frame);

  /// Optimises the whole graph. May be called again; tracking may go on after it.
  void finish();

  /// The path of the camera in the submap with most frames; for kFinal, after joining. Frames of
  /// other submaps are lost.
  [[nodiscard]] Trajectory trajectory(TrajectoryView view = TrajectoryView::kFinal) const;
  /// Nodes are keyframes; their ids are the keyframes' numbers.
  [[nodiscard]] PoseGraph pose_graph() const;
  [[nodiscard]] std::vector<Keyframe> keyframes() const;
  /// Every pair that was tried, with its verdict.
  [[nodiscard]] std::vector<LoopCandidate> loop_candidates() const;
  [[nodiscard]] GraphStatistics statistics() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace cvo_slam
