// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/point_cloud.h"
#include "cvo_slam/core/rgbd_frame.h"
#include "cvo_slam/core/trajectory.h"
#include "cvo_slam/frontend/registration.h"
#include "cvo_slam/frontend/tracker_options.h"

namespace cvo_slam {

enum class TrackingStatus {
  kTracked,
  kLost,  ///< no pose; FrameRecord::reason says why
};

/// What the tracker has to say of one frame.
struct FrameRecord {
  std::size_t index = 0;  ///< RgbdFrame::index
  Timestamp stamp;
  TrackingStatus status = TrackingStatus::kLost;
  std::string reason;  ///< why it is lost; empty where it is tracked
  SE3 T_world_camera;  ///< valid where tracked
  /// A new one starts where tracking resumes after too long a loss. Poses of different segments are
  /// of different worlds.
  int segment = 0;
  std::size_t keyframe = 0;     ///< index of the frame it was registered against
  std::string keyframe_reason;  ///< why it became a keyframe itself; empty where it did not
  /// An earlier frame that was made the keyframe because this one could not be registered against
  /// the one there was; empty as a rule.
  std::optional<std::size_t> promoted_keyframe;
  std::size_t points = 0;           ///< points selected
  RegistrationResult registration;  ///< against the keyframe; T_fixed_moving = T_keyframe_camera
};

/// Told of each keyframe: its frame and its points, at its stamp. They are lent for the call.
using KeyframeObserver = std::function<void(const RgbdFrame& frame, const PointCloud& cloud)>;

/// Tracks the pose of an RGB-D camera, frame by frame, against keyframes.
class Tracker {
 public:
  /// Throws OptionError where the camera or an option is impossible.
  explicit Tracker(const Camera& camera, const TrackerOptions& options = {});
  ~Tracker();
  Tracker(Tracker&& other) noexcept;
  Tracker& operator=(Tracker&& other) noexcept;

  /// Tracks the next frame. Never throws on a bad image: the answer is kLost with a reason.
  /// The first tracked camera is the origin of the world.
  FrameRecord track(const RgbdFrame& frame);

  /// Goes on where T_world_camera says that a frame was taken which track() has just called lost,
  /// for one who has recognised the place: a new segment starts there, in whatever world the pose
  /// is of. Lost it stays where its images are of no use.
  FrameRecord resume(const RgbdFrame& frame, const SE3& T_world_camera);

  /// The observer is called within these, in the order in which keyframes are made, once for each
  /// but the first of a segment: that is made again, with other points, when the next frame has
  /// told how the camera moves.
  void observe_keyframes(KeyframeObserver observer);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The camera's path from the tracker's answers: the frames of the segment with most of them; all
/// others are lost.
[[nodiscard]] Trajectory to_trajectory(const std::vector<FrameRecord>& records);

}  // namespace cvo_slam
