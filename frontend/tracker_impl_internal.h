// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the tracker's two sources share: tracker.cc follows a frame's way, tracker_registration.cc
// finds its pose.
#pragma once

#include <atomic>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cvo_slam/core/exclusive_access.h"
#include "cvo_slam/core/saved_state.h"
#include "cvo_slam/frontend/exposure_internal.h"
#include "cvo_slam/frontend/motion_model_internal.h"
#include "cvo_slam/frontend/tracker.h"
#include "cvo_slam/frontend/tracking_doubt_internal.h"
#include "cvo_slam/frontend/tracking_judgement_internal.h"

namespace cvo_slam {

void exchange(SavedState& state, Exposure& exposure);

/// A registration of the frame in work to a keyframe, with its judgement.
struct Registered {
  std::size_t keyframe = 0;  // index of its frame
  RegistrationResult result;
  SE3 T_world_camera;
  std::string fault;  // why it is not believed; empty if it is
  double doubt = 1;
  std::optional<DoubtEvidence> evidence = std::nullopt;  // of the doubt; none of a failure
  /// Another answer that is as good, unless features agree with this one.
  std::optional<SE3> T_keyframe_rival = std::nullopt;
  std::optional<std::size_t> promoted_keyframe = std::nullopt;

  [[nodiscard]] bool is_believed() const { return fault.empty(); }
  [[nodiscard]] bool is_doubtful() const {
    return !is_believed() || doubt > kDoubtful || T_keyframe_rival;
  }
};

/// The keyframe that frames are registered to.
struct CurrentKeyframe {
  std::size_t frame = 0;  // index of its frame
  SE3 T_world_camera;
  bool is_last_tracked = false;  // true until a later frame is tracked
  bool lacks_velocity = false;   // true if its points were selected without the camera's motion
  Exposure exposure;

  void exchange(SavedState& state) {
    state(frame, T_world_camera, is_last_tracked, lacks_velocity, exposure);
  }
};

/// Where the frame in work may be.
struct FrameStarts {
  SE3 T_predicted;                      // by the velocity
  std::optional<SE3> T_seen;            // the same, turned as the images say
  std::optional<SE3> T_keyframe_found;  // by features, to the keyframe
  bool features_asked = false;
  bool found_was_refused = false;    // true if the registration from there is not believed
  std::vector<Answer> answers;       // that registrations to the keyframe gave
  std::vector<SE3> T_world_refused;  // believed answers that were refused, and their rivals

  /// Forgets what is known relative to the keyframe, which is another one now.
  void forget_keyframe() {
    T_keyframe_found.reset();
    found_was_refused = false;
    answers.clear();  // keeps its memory for the next frame
  }
  /// Forgets all but the prediction.
  void clear() {
    forget_keyframe();
    T_seen.reset();
    T_world_refused.clear();
    features_asked = false;
  }
};

/// Keyframes are always made of the last tracked frame, whose pose is motion.last_pose().
struct Tracker::Impl {
  Impl(const Camera& camera_in, const TrackerOptions& options_in);

  std::atomic_flag in_use;  // see ExclusiveAccess
  Camera camera;
  TrackerOptions options;
  PointSelector selector;
  FieldOfView field_of_view;
  Registration registration;  // to the current keyframe
  MotionModel motion;
  ExposureGain exposure;
  KeyframePolicy policy;
  UsualSimilarity usual;

  PreparedFrame frame;  // the one given last; after it was tracked, memory
  PointCloud seen;      // its points as its rows saw them
  PointCloud points;    // its points at its stamp
  PointCloud keyframe_points;
  std::string image_problem = "no frame was given yet";  // why its images are of no use
  FrameRecord blank;                                     // its record before anything is known
  bool frame_is_last_tracked = false;                    // true if it is in last_tracked now
  PreparedFrame last_tracked;
  RgbdFrame keyframe_images;  // its index and copies of its images
  std::optional<CurrentKeyframe> keyframe;
  std::optional<TrackerKeyframe> pending;  // made of the last tracked frame, not yet returned
  bool pending_was_taken = false;          // true if that was returned by take_keyframe()
  int submap = 0;
  int lost_in_a_row = 0;
  Timestamp first_lost;  // stamp of the first of these
  FrameStarts starts;
  std::optional<DoubtEvidence> evidence;  // of the frame given last

  TrackedFrame track(const RgbdFrame& given, const StartFinder& find_start);
  FrameRecord resume(const SE3& T_world_camera);
  PointCloud select_keyframe_points();
  void exchange(SavedState& state);

  void prepare(const RgbdFrame& given);
  [[nodiscard]] std::string select_points_of_frame();
  [[nodiscard]] int number_of_points() const;
  void select(const PreparedFrame& from, int count, PointCloud& cloud);
  void undo_shutter(const Vector6& velocity, PointCloud& cloud) const;
  void place_points(const Vector6& velocity);
  [[nodiscard]] bool has_rolling_shutter() const {
    return options.compensate_rolling_shutter && camera.readout_time > 0;
  }

  [[nodiscard]] bool is_lost_for_long() const;
  [[nodiscard]] double nearest_surprise(const SE3& T_world_camera) const;
  [[nodiscard]] double share_of_rival(const RegistrationResult& result) const;
  [[nodiscard]] SE3 pose_as_seen(const SE3& T_last_camera) const;
  Registered register_frame(const StartFinder& find_start);
  void try_seen_start(Registered& best);
  void try_found_start(const StartFinder& find_start, Registered& best);
  [[nodiscard]] bool is_elsewhere(const Registered& registered) const;
  [[nodiscard]] bool is_certain(const Registered& registered) const;
  void refuse_if_doubtful(Registered& registered) const;
  void refuse_for_now(Registered& registered);
  void find_doubt(Registered& registered) const;
  void find_rival(Registered& registered) const;
  Registered register_from(const SE3& T_world_camera_init, int skip);
  void judge(Registered& registered) const;
  [[nodiscard]] TrackingSituation situation_of(const Registered& registered, bool is_lost) const;
  Registered register_to_remade_keyframe(const Registered& first);

  [[nodiscard]] FrameRecord accept(FrameRecord record);
  void observe_exposure(const SE3& T_keyframe_frame);
  [[nodiscard]] FrameRecord start_submap(FrameRecord record, const SE3& T_world_camera);
  [[nodiscard]] FrameRecord reject(FrameRecord record, const std::string& reason);
  void keep_as_last_tracked(const SE3& T_world_camera);
  void make_keyframe();
};

}  // namespace cvo_slam
