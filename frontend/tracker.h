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
#include "cvo_slam/core/options.h"
#include "cvo_slam/core/point_cloud.h"
#include "cvo_slam/core/rgbd_frame.h"
#include "cvo_slam/core/trajectory.h"
#include "cvo_slam/frontend/point_selection.h"
#include "cvo_slam/frontend/registration.h"

namespace cvo_slam {

class SavedState;
struct DoubtEvidence;

/// What a frame is registered to.
enum class Reference {
  kKeyframe,       ///< the current keyframe
  kPreviousFrame,  ///< the paper's choice
};

/// Where a registration starts.
enum class Prediction {
  kConstantVelocity,  ///< the pose that the last velocity leads to
  kIdentity,          ///< the pose of the keyframe: the paper's choice
};

/// When a tracked frame becomes the next keyframe: when one of the three limits is passed.
struct KeyframeOptions {
  /// Least overlap with the keyframe, as a share of the overlap that can be expected, in [0, 1].
  /// The expected overlap is the best one of the last keyframes, because some points never find a
  /// partner where depth is missing in patches. 0.8 keeps the drift low on all test sequences;
  /// 0.56 raises fr1/rpy's RPE by a quarter. Raise it for fast turns, lower it to get fewer
  /// keyframes.
  double min_overlap = 0.8;
  /// Largest distance from the keyframe [m]. Near objects look different from further away than
  /// 0.20. Raise it where everything is several metres away.
  double max_translation = 0.20;
  /// Largest rotation against the keyframe [rad]. 0.25 is a quarter of a Kinect's field of view;
  /// raise it for a camera with a wider one.
  double max_rotation = 0.25;
};

/// When a frame counts as lost, and what happens then.
struct LostOptions {
  /// Least number of points of a frame. Six degrees of freedom need eight points each; a wall
  /// without texture leaves about a hundred. Raise it where single small objects mislead.
  int min_points = 50;
  /// Least overlap of a registration, in [0, 1]; twice as much is asked for after a long loss.
  /// 0.3 accepts what a fast turn leaves of the keyframe. Raise it where false poses occur.
  double min_overlap = 0.3;
  /// Least normalised inner product of the clouds, in [0, 1].
  double min_cos_theta = 0.1;
  /// Largest speed of the camera [m/s]. No hand moves a camera faster than 3 m/s: such a step is a
  /// false registration, unless nothing else casts doubt on it (FrameRecord::doubt of at most 0.02;
  /// stamps may be counted and not measured). Raise it for vehicles and drones.
  double max_speed = 3.0;
  /// Largest angular speed of the camera [rad/s], in the same way. No hand turns a camera faster
  /// than 6 rad/s.
  double max_angular_speed = 6.0;
  /// Largest probability that the pose is wrong by more than 5 cm or 3 degrees, in [0, 1]
  /// (FrameRecord::doubt); 1 = any. Lower it where a wrong pose is worse than none: 0.5 refuses
  /// two fifths of those that are wrong and have passed all else, and 7 in 1000 of those that are
  /// right. Nothing is lost by default, because at a few frames a second most of that is right; but
  /// above 0.5 another keyframe, the last tracked frame, is asked.
  double max_doubt = 1;
  /// Time from the first lost frame on after which a new submap starts [s]: 0.3 s, 10 frames at
  /// 30 Hz, bridge a hand before the camera.
  double restart_time = 0.3;
  /// Number of lost frames before which none starts, however long they take [frames]. Slam raises
  /// it so that enough frames can say where the camera is (RelocalizationOptions::frames).
  int restart_frames = 4;
};

/// How a camera is tracked.
struct TrackerOptions {
  /// Number of points of a frame. Twice as many cost twice the time and gain nothing at 30 frames a
  /// second; they are taken, up to keyframe_points, where the last tracked frame is more than 0.05
  /// s ago (with Prediction::kConstantVelocity), because frames far apart have fewer in common.
  /// Lower it for slow machines.
  int points = 1500;
  /// Number of points of a keyframe. More than of a frame, so that most points of a frame find
  /// the very same spot of a surface.
  int keyframe_points = 6000;
  /// Number of threads of one registration. Results do not depend on it. One thread costs the least
  /// CPU time; take more where a frame takes longer than the camera's period.
  int threads = 1;
  /// True to take the predicted motion between the stamps of the colour and the depth image out of
  /// the points: sensors without a common clock take the two up to 17 ms apart. Switch it off where
  /// the stamps of the depth images are not to be trusted.
  bool compensate_depth_delay = true;
  /// True to take the motion while the rows were read (Camera::readout_time) out of the points. It
  /// changes nothing for a camera with a global shutter, whose readout time is 0.
  bool compensate_rolling_shutter = true;
  /// True to scale the colours of a frame back where the whole image has become brighter or darker
  /// by one factor, of more than 15 %, since the frame before or the keyframe. Switch it off for
  /// cameras with a fixed exposure, where only the light can do that.
  bool compensate_exposure = true;
  Reference reference = Reference::kKeyframe;             ///< what a frame is registered to
  Prediction prediction = Prediction::kConstantVelocity;  ///< where a registration starts
  int recovery_scales = 1;  ///< coarsest length scales that serve only after a failed registration
  SelectionOptions selection;        ///< which pixels become points
  RegistrationOptions registration;  ///< how a frame is registered
  KeyframeOptions keyframe;          ///< when a frame becomes the next keyframe
  LostOptions lost;                  ///< when a frame counts as lost
};

///@{
/// Returns the options with their keys, ranges and documentation.
[[nodiscard]] OptionSet describe(KeyframeOptions& options);
[[nodiscard]] OptionSet describe(LostOptions& options);
[[nodiscard]] OptionSet describe(TrackerOptions& options);
///@}

/// Throws OptionError if options that are each in range contradict one another.
void check_consistency(const TrackerOptions& options);

/// Returns the paper's whole protocol: previous frame as reference, identity start, gradient flow,
/// linear colour kernel, edge points, and its table of constants.
[[nodiscard]] TrackerOptions paper_options();

/// Whether a frame has a pose.
enum class TrackingStatus {
  kTracked,  ///< FrameRecord::T_world_camera is its pose
  kLost,     ///< no pose; FrameRecord::reason says why
};

/// The tracker's result for one frame.
struct FrameRecord {
  std::size_t index = 0;                          ///< RgbdFrame::index
  Timestamp stamp;                                ///< RgbdFrame::stamp
  TrackingStatus status = TrackingStatus::kLost;  ///< whether the frame has a pose
  std::string reason;                             ///< why the frame is lost; empty if it is tracked
  SE3 T_world_camera;                             ///< valid if the frame is tracked
  /// Number of the submap of the tracker; in the answers of Slam::track() the name of the joined
  /// submap. A new one starts where tracking resumes after too long a loss. Poses of different
  /// submaps have different worlds.
  int submap = 0;
  /// True if Slam was made from a map and the pose is in the world of that map. A camera that has
  /// left the places of a map that is not extended is tracked on, with false here.
  bool localized = false;
  std::size_t keyframe = 0;     ///< index of the frame that this one was registered to
  std::string keyframe_reason;  ///< why the frame became a keyframe; empty if it did not
  /// Index of an earlier frame that was made the keyframe because this one could not be registered
  /// to the one before; empty as a rule.
  std::optional<std::size_t> promoted_keyframe;
  /// Probability that the pose relative to the keyframe is wrong by more than 5 cm or 3 degrees, by
  /// a model that was fitted to recordings with true poses. Of a lost frame, that of the last try.
  double doubt = 0;
  bool features_asked = false;      ///< true if a start was looked for by features (StartFinder)
  std::size_t points = 0;           ///< number of selected points
  RegistrationResult registration;  ///< to the keyframe: T_fixed_moving = T_keyframe_camera
};

/// A keyframe whose points are final: frames are registered to them from now on.
struct TrackerKeyframe {
  std::size_t frame = 0;                    ///< index of its frame
  std::shared_ptr<const PointCloud> cloud;  ///< its points, at its stamp
  RgbdFrame images;  ///< its images; the memory is shared, never written again
};

/// Finds T_keyframe_camera of a frame from the images of the two, whatever the motion between them:
/// by features, for example. None if it cannot. The keyframe's pose is told to those who also
/// compare the frame with other images of the same submap.
using StartFinder = std::function<std::optional<SE3>(
    const RgbdFrame& keyframe, const SE3& T_world_keyframe, const RgbdFrame& frame)>;

/// What Tracker::track() returns for a frame.
struct TrackedFrame {
  FrameRecord record;  ///< its pose, or why it has none
  /// The keyframe that became final with this frame; always an earlier frame. Empty as a rule.
  std::optional<TrackerKeyframe> keyframe;
};

/// Tracks the pose of an RGB-D camera, frame by frame, against keyframes. An object serves one
/// thread at a time, and none after it was moved from: every function throws UsageError otherwise.
class Tracker {
 public:
  /// Throws OptionError if the camera or an option is impossible.
  explicit Tracker(const Camera& camera, const TrackerOptions& options = {});
  ~Tracker();
  ///@{
  /// Takes over the state of `other`, whose functions throw UsageError from then on.
  Tracker(Tracker&& other) noexcept;
  Tracker& operator=(Tracker&& other) noexcept;
  ///@}

  /// Tracks the next frame, whose images are copied. Never throws on a bad image: the status is
  /// kLost then, with a reason. The first tracked camera is the origin of the world. `find_start`
  /// is asked for another start of the registration where its answer is not to be trusted: where it
  /// is doubtful (above 0.02) or not believed. Of the answers from different starts the one that
  /// agrees with a found start is taken, otherwise the most similar one.
  TrackedFrame track(const RgbdFrame& frame, const StartFinder& find_start = {});

  /// Continues at the frame that track() was given last and called lost, at a pose that a caller
  /// has recognised: a new submap starts there. Take the newest keyframe before: one that was not
  /// taken is dropped. The status stays kLost, with a reason, if the frame's images are of no use.
  FrameRecord resume(const SE3& T_world_camera);

  /// Returns the newest keyframe if track() has not returned it yet: for the end of a sequence, and
  /// before relocalisation. It is not returned again.
  std::optional<TrackerKeyframe> take_keyframe();

  /// Selects points of the frame that track() was given last as for a keyframe, with its exposure
  /// gain taken out: what relocalisation registers. Empty if its images are unusable.
  PointCloud select_keyframe_points();

  /// Writes all that later frames depend on, between two calls of track(), or takes it over, so
  /// that this object goes on bit for bit where another one with the same camera and options was.
  /// Throws DataError if the bytes are not those of such a state; the object is not to be used
  /// then.
  void exchange(SavedState& state);

 private:
  friend std::optional<DoubtEvidence> last_evidence(const Tracker& tracker);

  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Returns the camera's path from the tracker's records: the frames of the submap with most of
/// them; all others are lost.
[[nodiscard]] Trajectory to_trajectory(const std::vector<FrameRecord>& records);

}  // namespace cvo_slam
