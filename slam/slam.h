// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/map.h"
#include "cvo_slam/core/pose_graph.h"
#include "cvo_slam/core/rgbd_frame.h"
#include "cvo_slam/core/trajectory.h"
#include "cvo_slam/frontend/tracker.h"
#include "cvo_slam/loop/vocabulary.h"
#include "cvo_slam/slam/loop_candidate.h"
#include "cvo_slam/slam/slam_options.h"

namespace cvo_slam {

/// Which poses a trajectory has.
enum class TrajectoryView {
  /// Every frame as the graph has its keyframe now.
  kFinal,
  /// The same with the poses and submaps that track() answered: those of the submap with most
  /// frames.
  kOnline,
};

/// What becomes of a map that Slam was made from.
enum class MapUse {
  kExtend,    ///< frames add to it; a part that never meets it stays a submap of its own
  kLocalize,  ///< it stays as it is, and frames are located in it
  /// Goes on between the same two frames of the same recording (MapContent::kSession).
  kResume,
};

/// How much of a Slam object its map has.
enum class MapContent {
  kKeyframes,  ///< what other recordings need: keyframes with their points and features, the graph
  /// All else, too, so that MapUse::kResume goes on bit for bit: 4 MB for the images and points of
  /// the newest keyframe, and 0.5 kB a frame.
  kSession,
};

/// A keyframe of the map.
struct Keyframe {
  /// RgbdFrame::index of its frame; files and edges name it so. Keyframes of a map that was loaded
  /// keep theirs, and those of new frames are counted on: the index plus one more than the largest
  /// number there.
  std::size_t number = 0;
  Timestamp stamp;     ///< stamp of its colour image
  int submap = 0;      ///< poses of different submaps are of different worlds
  SE3 T_world_camera;  ///< its present pose in the graph
};

/// A depth image that is not paired with a colour image yet.
struct DepthImage {
  cv::Mat depth;    ///< as RgbdFrame::depth
  Timestamp stamp;  ///< as the sensor gives it, without Camera::depth_offset
};

/// What a Slam object tells while it tracks. Either function may be empty. They are called in the
/// thread of track() or finish() once its work is done, so that a slow one makes the caller wait
/// and changes no result; they must not call the object. What they throw, track() or finish()
/// throws after both were called, and tracking may go on.
struct SlamObserver {
  /// Called by each track() with the record that it is about to return.
  std::function<void(const FrameRecord&)> frame = {};
  /// Called before that with keyframes that an optimisation has moved, each with its new pose:
  /// those near the newest one now and then, all when a loop was closed. Corrections
  /// come with the delay of track() (SlamOptions::correction_delay), and in finish() without.
  /// Keyframes that were removed since (CullingOptions) are not among them: keyframes() lists those
  /// that there are.
  std::function<void(const std::vector<Keyframe>&)> correction = {};
};

/// Tracks an RGB-D camera and builds a map of keyframes. Registrations between near keyframes hold
/// the drift down, and keyframes that are recognised by their images take it out (loops).
///
///     Slam slam(camera);
///     while (grab(frame)) slam.track(frame);
///     slam.finish();
///     write_tum("trajectory.txt", slam.trajectory());
///
/// A lost camera is searched for among the keyframes; when a few frames in a row agree on where it
/// is, tracking goes on from there. Otherwise a new submap starts after a while (LostOptions), in a
/// world of its own, and is joined with another one when enough of its keyframes say how. Joined
/// submaps share the name of the first of them.
///
/// Results do not depend on the number of threads, the schedule or timing. Until finish() the
/// functions below answer for the keyframes that the map has so far; they wait for work that is
/// under way. An object serves one thread at a time, and none after it was moved from: every
/// function throws UsageError otherwise.
class Slam {
 public:
  /// Throws OptionError if the camera or an option is impossible. Loops use the built-in vocabulary
  /// if `vocabulary` is null.
  explicit Slam(const Camera& camera, const SlamOptions& options = {},
                const std::shared_ptr<const Vocabulary>& vocabulary = nullptr);
  /// Goes on from a map that map() returned or read_map() has read, with the camera that it was
  /// made with. Frames are numbered from 0 again. kExtend: tracking starts in a submap of its own,
  /// which is joined with the map as soon as enough keyframes say where it is. kLocalize: frames
  /// have a pose in the map (FrameRecord::localized) once some in a row agree on where the camera
  /// is; the cost of a frame does not grow. kResume: the object answers as the one would have that
  /// map(MapContent::kSession) was called of, bit for bit if options and vocabulary are the same;
  /// frames are numbered on, and an observer is to be given anew: what has moved since the last
  /// correction that one was told, keyframes() says. Times in statistics() begin anew. Throws
  /// DataError if the map has no memory (Map::memory) or its parts do not belong together, and
  /// OptionError.
  explicit Slam(const Map& map, const SlamOptions& options = {}, MapUse use = MapUse::kExtend,
                const std::shared_ptr<const Vocabulary>& vocabulary = nullptr);
  ~Slam();
  ///@{
  /// Takes over the state of `other`, whose functions throw UsageError from then on.
  Slam(Slam&& other) noexcept;
  Slam& operator=(Slam&& other) noexcept;
  ///@}

  /// Tracks the next frame. A bad image does not throw: the answer is kLost with a reason.
  /// T_world_camera contains the corrections that the map has computed up to
  /// SlamOptions::correction_delay keyframes ago. Throws DataError if RgbdFrame::index is not above
  /// that of the frame before.
  FrameRecord track(const RgbdFrame& frame);
  /// Tracks the colour image of `frame` with one of several depth images, say the one before and
  /// the one after it: the one that is nearest in time once Camera::depth_offset was added to its
  /// stamp, of two the earlier. What `frame` says of depth does not matter. Throws DataError if
  /// there is no depth image.
  FrameRecord track(RgbdFrame frame, const std::vector<DepthImage>& depths);

  /// The least RgbdFrame::index that track() takes next.
  [[nodiscard]] std::size_t next_index() const;

  /// Optimises the whole graph. May be called again; tracking may go on after it.
  void finish();

  /// Calls these functions from now on, in place of earlier ones.
  void observe(SlamObserver observer);

  /// The path of the camera in the submap with most frames; for kFinal, after joining. In a map
  /// that was loaded, if any frame is located in it. Frames of other submaps are lost.
  [[nodiscard]] Trajectory trajectory(TrajectoryView view = TrajectoryView::kFinal) const;
  /// Nodes are keyframes; their ids are the keyframes' numbers.
  [[nodiscard]] PoseGraph pose_graph() const;
  /// All keyframes, in the order of the nodes of pose_graph().
  [[nodiscard]] std::vector<Keyframe> keyframes() const;
  /// The map, to be written by write_map() or given to another Slam; without the coloured surface
  /// (Map::points).
  [[nodiscard]] Map map(MapContent content = MapContent::kKeyframes) const;
  /// Every pair that was tried, with its verdict.
  [[nodiscard]] std::vector<LoopCandidate> loop_candidates() const;
  /// How often the graph was optimised so far, and how long that took.
  [[nodiscard]] GraphStatistics statistics() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace cvo_slam
