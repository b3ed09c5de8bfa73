// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/frontend/tracker.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "cvo_slam/core/exclusive_access.h"
#include "cvo_slam/frontend/exposure_internal.h"
#include "cvo_slam/frontend/motion_model_internal.h"
#include "cvo_slam/frontend/tracking_judgement_internal.h"

namespace cvo_slam {
namespace {

const Camera& checked(const Camera& camera) {
  camera.check();
  return camera;
}

TrackerOptions checked(TrackerOptions options) {
  describe(options).check();
  check_consistency(options);
  return options;
}

/// A registration of the frame in work to a keyframe, with its judgement.
struct Registered {
  std::size_t keyframe = 0;  // index of its frame
  RegistrationResult result;
  SE3 T_world_camera;
  std::string fault;  // why it is not believed; empty if it is
  std::optional<std::size_t> promoted_keyframe = std::nullopt;

  [[nodiscard]] bool is_believed() const { return fault.empty(); }
};

/// The keyframe that frames are registered to.
struct CurrentKeyframe {
  std::size_t frame = 0;  // index of its frame
  SE3 T_world_camera;
  bool is_last_tracked = false;  // true until a later frame is tracked
  bool lacks_velocity = false;   // true if its points were selected without the camera's motion
};

}  // namespace

/// Keyframes are always made of the last tracked frame, whose pose is motion.last_pose().
struct Tracker::Impl {
  Impl(const Camera& camera_in, const TrackerOptions& options_in)
      : camera(camera_in),
        options(checked(options_in)),
        selector(checked(camera), options.selection),
        field_of_view(camera.color),
        registration(options.registration, options.threads),
        policy(options.keyframe) {}

  std::atomic_flag in_use;  // see ExclusiveAccess
  Camera camera;
  TrackerOptions options;
  PointSelector selector;
  FieldOfView field_of_view;
  Registration registration;  // to the current keyframe
  MotionModel motion;
  ExposureGain exposure;
  KeyframePolicy policy;

  PreparedFrame frame;  // the one given last; after it was tracked, memory
  PointCloud seen;      // its points as its rows saw them
  PointCloud points;    // its points at its stamp
  PointCloud keyframe_points;
  std::string image_problem = "no frame was given yet";  // why its images are of no use
  FrameRecord blank;                                     // its record before anything is known
  bool frame_is_last_tracked = false;                    // true if it is in last_tracked now
  PreparedFrame last_tracked;
  RgbdFrame keyframe_images;
  std::optional<CurrentKeyframe> keyframe;
  std::optional<TrackerKeyframe> pending;  // made of the last tracked frame, not yet returned
  bool pending_was_taken = false;          // true if that was returned by take_keyframe()
  int submap = 0;
  int lost_in_a_row = 0;

  TrackedFrame track(const RgbdFrame& given, const StartFinder& find_start);
  FrameRecord resume(const SE3& T_world_camera);
  PointCloud select_keyframe_points();

  void prepare(const RgbdFrame& given);
  [[nodiscard]] std::string select_points_of_frame();
  void select(const PreparedFrame& from, int count, PointCloud& cloud);
  void undo_shutter(const Vector6& velocity, PointCloud& cloud) const;
  [[nodiscard]] bool has_rolling_shutter() const {
    return options.compensate_rolling_shutter && camera.readout_time > 0;
  }

  [[nodiscard]] bool is_far(const Timestamp& stamp) const;
  Registered register_frame(const StartFinder& find_start);
  void try_found_start(const StartFinder& find_start, Registered& best);
  Registered register_from(const SE3& T_world_camera_init, int skip);
  [[nodiscard]] TrackingSituation situation_of(const Registered& registered, bool is_lost) const;
  Registered register_to_remade_keyframe(const Registered& first);

  [[nodiscard]] FrameRecord accept(FrameRecord record);
  [[nodiscard]] FrameRecord start_submap(FrameRecord record, const SE3& T_world_camera);
  [[nodiscard]] FrameRecord reject(FrameRecord record, const std::string& reason);
  void keep_as_last_tracked(const SE3& T_world_camera);
  void make_keyframe();
};

TrackedFrame Tracker::Impl::track(const RgbdFrame& given, const StartFinder& find_start) {
  prepare(given);
  FrameRecord record = blank;
  const std::string problem = select_points_of_frame();
  record.points = seen.size();
  if (!problem.empty()) return {reject(std::move(record), problem), std::nullopt};
  if (!keyframe) return {start_submap(std::move(record), motion.last_pose()), std::nullopt};

  const Registered registered = register_frame(find_start);
  record.keyframe = registered.keyframe;
  record.promoted_keyframe = registered.promoted_keyframe;
  record.registration = registered.result;
  record.T_world_camera = registered.T_world_camera;
  if (!registered.is_believed()) {
    record = reject(std::move(record), registered.fault);
    if (lost_in_a_row < options.lost.restart_after) return {std::move(record), std::nullopt};
  }
  // The pending keyframe is final: frames after this one are registered to another keyframe or to
  // this one as it is. It can be handed out.
  std::optional<TrackerKeyframe> final_keyframe = std::exchange(pending, std::nullopt);
  if (registered.is_believed()) return {accept(std::move(record)), std::move(final_keyframe)};
  // Lost for too long: a new submap starts where the camera was last.
  record.submap = ++submap;
  return {start_submap(std::move(record), motion.last_pose()), std::move(final_keyframe)};
}

FrameRecord Tracker::Impl::resume(const SE3& T_world_camera) {
  FrameRecord record = blank;
  record.reason = frame_is_last_tracked ? "the frame is tracked already" : select_points_of_frame();
  record.points = seen.size();
  if (!record.reason.empty()) return record;
  record.submap = ++submap;
  return start_submap(std::move(record), T_world_camera);
}

/// A lost camera's motion is not known, so that none is taken out.
PointCloud Tracker::Impl::select_keyframe_points() {
  PointCloud cloud;
  if (!image_problem.empty()) return cloud;
  selector.select(frame_is_last_tracked ? last_tracked : frame, options.keyframe_points, SE3(),
                  cloud);
  return cloud;
}

/// Makes the given frame the one in work.
void Tracker::Impl::prepare(const RgbdFrame& given) {
  blank.index = given.index;
  blank.stamp = given.stamp;
  blank.submap = submap;
  frame_is_last_tracked = false;
  image_problem = check_images(given, camera);
  if (!image_problem.empty()) return;
  frame = selector.prepare(given, std::move(frame));
  if (options.compensate_exposure) frame.exposure_gain = exposure.update(frame.images.color);
}

/// Selects the points of the frame in work; returns why it cannot be tracked, or nothing.
std::string Tracker::Impl::select_points_of_frame() {
  seen.clear();
  if (!image_problem.empty()) return image_problem;
  select(frame, options.points, seen);
  if (seen.size() >= static_cast<std::size_t>(options.lost.min_points)) return {};
  return fmt::format("only {} points with gradient and depth", seen.size());
}

/// Selects points as the rows saw them; the motion between the two images is taken out.
void Tracker::Impl::select(const PreparedFrame& from, int count, PointCloud& cloud) {
  // A longer delay is a depth stamp that was not set.
  constexpr double kMaxDelay = 0.1;  // [s]
  const RgbdFrame& images = from.images;
  const double delay =
      seconds_between(images.stamp, images.depth_stamp) + camera.depth_offset.value_or(0);
  const bool compensate = options.compensate_depth_delay && std::abs(delay) < kMaxDelay;
  const SE3 T_color_depth = compensate ? motion.motion_during(delay) : SE3();
  selector.select(from, count, T_color_depth, cloud);
}

/// Takes the motion while the rows were read out of the points.
void Tracker::Impl::undo_shutter(const Vector6& velocity, PointCloud& cloud) const {
  if (!has_rolling_shutter()) return;
  undo_rolling_shutter(velocity, camera.readout_time, camera.color.height, cloud);
}

/// Returns true if the camera may have left its predicted way by more than fine kernels reach: a
/// hand turns ever faster by 20 rad/s^2 at most, in this time by 0.025 rad, and points 2 m away
/// move by 0.05 m.
bool Tracker::Impl::is_far(const Timestamp& stamp) const {
  constexpr double kLongestPrediction = 0.05;  // [s]
  return seconds_between(motion.last_stamp(), stamp) > kLongestPrediction;
}

/// Registers from the predicted pose; if that fails, with all length scales, and so too if the last
/// frame is long ago: the more similar of the two answers is taken; if that fails too,
/// without the velocity; and at last to the last tracked frame, the most similar one there is. That
/// attempt makes it the keyframe, which it stays even if the attempt fails. A failure also forgets
/// the velocity. The first success with a keyframe that was made without it, as at a start, makes
/// that keyframe again.
Registered Tracker::Impl::register_frame(const StartFinder& find_start) {
  const Timestamp stamp = frame.images.stamp;
  if (stamp <= motion.last_stamp()) {
    Registered none;
    none.fault = fmt::format("its stamp is not after the stamp {} of the last tracked frame",
                             motion.last_stamp().to_string());
    return none;
  }
  const bool predict = options.prediction == Prediction::kConstantVelocity;
  const bool from_velocity = predict && motion.has_velocity();
  const int skip = from_velocity ? options.recovery_scales : 0;
  const SE3 T_init = predict ? motion.predict(stamp) : keyframe->T_world_camera;
  Registered registered = register_from(T_init, skip);
  if (skip > 0 && (!registered.is_believed() || is_far(stamp))) {
    const Registered wider = register_from(T_init, 0);
    const bool is_better =
        !registered.is_believed() ||
        (wider.is_believed() && wider.result.cos_theta > registered.result.cos_theta);
    if (is_better) registered = wider;
  }
  if (!registered.is_believed() || is_far(stamp)) try_found_start(find_start, registered);
  if (!registered.is_believed() && from_velocity) registered = register_from(motion.last_pose(), 0);
  if (!registered.is_believed() && !keyframe->is_last_tracked) {
    make_keyframe();
    registered = register_from(motion.last_pose(), 0);
    if (!registered.is_believed()) try_found_start(find_start, registered);
    registered.promoted_keyframe = keyframe->frame;
  }
  if (registered.is_believed() && predict && keyframe->lacks_velocity) {
    registered = register_to_remade_keyframe(registered);
  }
  if (!registered.is_believed()) motion.forget_velocity();
  return registered;
}

/// Registers from the start that `find_start` finds. Its answer replaces `best` if it stays near
/// that start and `best` is elsewhere, because two ways to measure agree then; otherwise if it is
/// the more similar one. Without such an answer, what is far from the start is not believed any
/// more.
void Tracker::Impl::try_found_start(const StartFinder& find_start, Registered& best) {
  if (!find_start) return;
  const auto T_keyframe_start = find_start(keyframe_images, frame.images);
  if (!T_keyframe_start) return;
  const auto is_near_start = [&](const Registered& registered, double translation,
                                 double rotation) {
    const SE3 difference = T_keyframe_start->inverse() * registered.result.T_fixed_moving;
    return difference.translation().norm() < translation && difference.angle() < rotation;
  };
  constexpr double kSameTranslation = 0.06;  // [m]; features of blurred images are as inexact
  constexpr double kSameRotation = 0.06;     // [rad]
  Registered found =
      register_from(keyframe->T_world_camera * *T_keyframe_start, options.recovery_scales);
  const bool agrees = is_near_start(found, kSameTranslation, kSameRotation);
  if (!found.is_believed() && agrees) {
    // Blurred images are less similar. That two measurements agree makes up for it.
    LostOptions lenient = options.lost;
    lenient.min_cos_theta *= 0.5;
    lenient.min_overlap *= 0.67;
    found.fault = find_fault(found.result, situation_of(found, false), lenient);
  }
  constexpr double kElsewhere = 2.5;  // times as far
  const bool best_is_elsewhere =
      best.is_believed() &&
      !is_near_start(best, kElsewhere * kSameTranslation, kElsewhere * kSameRotation);
  if (found.is_believed()) {
    const bool is_better = !best.is_believed() || (agrees && best_is_elsewhere) ||
                           found.result.cos_theta > best.result.cos_theta;
    if (is_better) best = found;
  } else if (best_is_elsewhere) {
    best.fault = "the features of the images say that the camera is elsewhere";
  }
}

/// Registers the frame in work to the keyframe from a start, and judges the result.
Registered Tracker::Impl::register_from(const SE3& T_world_camera_init, int skip) {
  const Timestamp stamp = frame.images.stamp;
  const SE3& T_world_keyframe = keyframe->T_world_camera;
  const SE3 T_init = T_world_keyframe.inverse() * T_world_camera_init;
  Registered registered;
  registered.keyframe = keyframe->frame;
  points = seen;
  undo_shutter(motion.velocity(), points);
  if (has_rolling_shutter()) {
    // The predicted velocity is a frame old: undo again with the one that was found.
    const Approach approach = registration.approach(points, T_init, skip);
    points = seen;
    undo_shutter(motion.velocity_to(stamp, T_world_keyframe * approach.T_fixed_moving), points);
    registered.result = registration.refine(points, approach);
  } else {
    registered.result = registration.align(points, T_init, skip);
  }
  registered.T_world_camera = T_world_keyframe * registered.result.T_fixed_moving;
  registered.fault =
      find_fault(registered.result, situation_of(registered, lost_in_a_row > 0), options.lost);
  return registered;
}

/// How far the frame in work would be from the last tracked one.
TrackingSituation Tracker::Impl::situation_of(const Registered& registered, bool is_lost) const {
  return {motion.last_pose().inverse() * registered.T_world_camera,
          seconds_between(motion.last_stamp(), frame.images.stamp), is_lost};
}

/// The first keyframe of a submap was made before its motion was known. Makes it again with the
/// motion to the frame that was just registered to it, and registers that frame, whose points are
/// selected again too.
Registered Tracker::Impl::register_to_remade_keyframe(const Registered& first) {
  motion.set_velocity(motion.velocity_to(frame.images.stamp, first.T_world_camera));
  make_keyframe();
  select(frame, options.points, seen);
  Registered registered = register_from(first.T_world_camera, options.recovery_scales);
  registered.promoted_keyframe = first.promoted_keyframe;
  return registered;
}

/// Takes the pose, and makes the frame a keyframe if the policy says so (`points` are those of
/// register_from()).
FrameRecord Tracker::Impl::accept(FrameRecord record) {
  record.status = TrackingStatus::kTracked;
  keep_as_last_tracked(record.T_world_camera);
  if (options.reference == Reference::kPreviousFrame) {
    record.keyframe_reason = "previous frame";
  } else {
    const RegistrationResult& result = record.registration;
    const double visible = visible_share(points, result.T_fixed_moving, field_of_view);
    record.keyframe_reason = policy.reason(result, visible);
  }
  if (!record.keyframe_reason.empty()) make_keyframe();
  return record;
}

FrameRecord Tracker::Impl::start_submap(FrameRecord record, const SE3& T_world_camera) {
  record.status = TrackingStatus::kTracked;
  record.reason.clear();
  record.T_world_camera = T_world_camera;
  record.keyframe = record.index;
  record.keyframe_reason = "start of a submap";
  record.registration = {};
  record.registration.status = RegistrationStatus::kConverged;
  record.registration.reason = "the keyframe itself";
  record.registration.overlap = 1;
  record.registration.cos_theta = 1;
  keep_as_last_tracked(T_world_camera);
  motion.forget_velocity();  // the camera did not move here from the last pose before
  make_keyframe();
  return record;
}

/// Counts a lost frame.
FrameRecord Tracker::Impl::reject(FrameRecord record, const std::string& reason) {
  ++lost_in_a_row;
  record.status = TrackingStatus::kLost;
  record.reason = reason;
  return record;
}

/// Moves the frame in work to last_tracked; `frame` is only memory afterwards.
void Tracker::Impl::keep_as_last_tracked(const SE3& T_world_camera) {
  lost_in_a_row = 0;
  std::swap(frame, last_tracked);
  motion.update(last_tracked.images.stamp, T_world_camera);
  frame_is_last_tracked = true;
  pending_was_taken = false;
  if (keyframe) keyframe->is_last_tracked = false;
}

/// Makes the last tracked frame the keyframe, or makes that one again with the motion known now.
void Tracker::Impl::make_keyframe() {
  const RgbdFrame& images = last_tracked.images;
  keyframe = {images.index, motion.last_pose(), true, !motion.has_velocity()};
  keyframe_images = images;
  policy.keyframe_made();
  select(last_tracked, options.keyframe_points, keyframe_points);
  undo_shutter(motion.velocity(), keyframe_points);
  registration.set_fixed(keyframe_points);
  // take_keyframe() has handed this one out; made again, it serves the registration only.
  if (pending_was_taken) return;
  // A copy has no more memory than it needs.
  pending = {images.index, std::make_shared<const PointCloud>(keyframe_points), images};
}

Tracker::Tracker(const Camera& camera, const TrackerOptions& options)
    : impl_(std::make_unique<Impl>(camera, options)) {}

Tracker::~Tracker() = default;
Tracker::Tracker(Tracker&&) noexcept = default;
Tracker& Tracker::operator=(Tracker&&) noexcept = default;

TrackedFrame Tracker::track(const RgbdFrame& frame, const StartFinder& find_start) {
  return ExclusiveAccess(impl_, "Tracker")->track(frame, find_start);
}

FrameRecord Tracker::resume(const SE3& T_world_camera) {
  return ExclusiveAccess(impl_, "Tracker")->resume(T_world_camera);
}

std::optional<TrackerKeyframe> Tracker::take_keyframe() {
  const ExclusiveAccess impl(impl_, "Tracker");
  if (impl->pending) impl->pending_was_taken = true;
  return std::exchange(impl->pending, std::nullopt);
}

PointCloud Tracker::select_keyframe_points() {
  return ExclusiveAccess(impl_, "Tracker")->select_keyframe_points();
}

Trajectory to_trajectory(const std::vector<FrameRecord>& records) {
  std::map<int, std::size_t> frames_of_submap;
  for (const auto& record : records) {
    if (record.status == TrackingStatus::kTracked) ++frames_of_submap[record.submap];
  }
  const auto main =
      std::max_element(frames_of_submap.begin(), frames_of_submap.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });

  Trajectory trajectory;
  for (const auto& record : records) {
    if (record.status == TrackingStatus::kLost) {
      trajectory.lost.push_back({record.stamp, record.reason});
    } else if (record.submap == main->first) {
      trajectory.poses.push_back({record.stamp, record.T_world_camera});
    } else {
      trajectory.lost.push_back(
          {record.stamp, fmt::format("submap {} is not connected to the trajectory's submap {}",
                                     record.submap, main->first)});
    }
  }
  return trajectory;
}

}  // namespace cvo_slam
