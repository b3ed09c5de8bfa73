// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/frontend/tracker.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "cvo_slam/frontend/tracker_impl_internal.h"

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

}  // namespace

Tracker::Impl::Impl(const Camera& camera_in, const TrackerOptions& options_in)
    : camera(camera_in),
      options(checked(options_in)),
      selector(checked(camera), options.selection),
      field_of_view(camera.color),
      registration(options.registration, options.threads),
      policy(options.keyframe) {}

TrackedFrame Tracker::Impl::track(const RgbdFrame& given, const StartFinder& find_start) {
  prepare(given);
  FrameRecord record = blank;
  evidence.reset();
  const std::string problem = select_points_of_frame();
  record.points = seen.size();
  if (!problem.empty()) return {reject(std::move(record), problem), std::nullopt};
  if (!keyframe) return {start_submap(std::move(record), motion.last_pose()), std::nullopt};

  const Registered registered = register_frame(find_start);
  record.keyframe = registered.keyframe;
  record.promoted_keyframe = registered.promoted_keyframe;
  record.doubt = registered.doubt;
  record.features_asked = starts.features_asked;
  evidence = registered.evidence;
  record.registration = registered.result;
  record.T_world_camera = registered.T_world_camera;
  if (!registered.is_believed()) {
    record = reject(std::move(record), registered.fault);
    if (!is_lost_for_long()) return {std::move(record), std::nullopt};
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
  if (options.compensate_exposure) frame.exposure = exposure.update(frame.images.color);
}

/// Selects the points of the frame in work; returns why it cannot be tracked, or nothing.
std::string Tracker::Impl::select_points_of_frame() {
  seen.clear();
  if (!image_problem.empty()) return image_problem;
  select(frame, number_of_points(), seen);
  if (seen.size() >= static_cast<std::size_t>(options.lost.min_points)) return {};
  return fmt::format("only {} points with gradient and depth", seen.size());
}

/// How many points the frame in work gets. After a long step it shows less of what the keyframe
/// shows, and there is time for twice as many, up to those of a keyframe.
int Tracker::Impl::number_of_points() const {
  const bool is_long_step = keyframe && options.prediction == Prediction::kConstantVelocity &&
                            motion.is_far(frame.images.stamp);
  if (!is_long_step) return options.points;
  return std::max(options.points, std::min(2 * options.points, options.keyframe_points));
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

/// Puts the points of the frame in work where they were at its stamp.
void Tracker::Impl::place_points(const Vector6& velocity) {
  points = seen;
  undo_shutter(velocity, points);
}

/// Takes the pose, and makes the frame a keyframe if the policy says so (`points` are those of
/// register_from()).
FrameRecord Tracker::Impl::accept(FrameRecord record) {
  record.status = TrackingStatus::kTracked;
  usual.add(record.registration.cos_theta);
  if (has_rolling_shutter()) {  // another attempt may have left its points
    place_points(motion.velocity_to(frame.images.stamp, record.T_world_camera));
  }
  observe_exposure(record.registration.T_fixed_moving);
  keep_as_last_tracked(record.T_world_camera);
  if (options.reference == Reference::kPreviousFrame) {
    record.keyframe_reason = "previous frame";
  } else {
    const RegistrationResult& result = record.registration;
    const double visible = visible_share(points, result.T_fixed_moving, field_of_view);
    record.keyframe_reason = policy.reason(result, visible);
  }
  if (record.keyframe_reason.empty()) return record;
  if (options.compensate_exposure) last_tracked.exposure = exposure.start_keyframe();
  make_keyframe();
  return record;
}

/// Compares the brightness of the frame in work with that of its keyframe.
void Tracker::Impl::observe_exposure(const SE3& T_keyframe_frame) {
  if (!options.compensate_exposure) return;
  const auto forward = log_brightness_ratio(points, frame.images, keyframe_images, T_keyframe_frame,
                                            camera, field_of_view);
  const auto backward = log_brightness_ratio(keyframe_points, keyframe_images, frame.images,
                                             T_keyframe_frame.inverse(), camera, field_of_view);
  if (!forward || !backward) return;
  frame.exposure = exposure.observe(keyframe->exposure, 0.5 * (*forward - *backward));
}

FrameRecord Tracker::Impl::start_submap(FrameRecord record, const SE3& T_world_camera) {
  record.status = TrackingStatus::kTracked;
  record.reason.clear();
  record.T_world_camera = T_world_camera;
  record.keyframe = record.index;
  record.keyframe_reason = "start of a submap";
  record.doubt = 0;
  evidence.reset();
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

/// True if a new submap is to start at the frame in work. A stamp that has jumped back is no less
/// far away.
bool Tracker::Impl::is_lost_for_long() const {
  const double seconds = std::abs(seconds_between(first_lost, frame.images.stamp));
  return lost_in_a_row >= options.lost.restart_frames && seconds >= options.lost.restart_time;
}

/// Counts a lost frame.
FrameRecord Tracker::Impl::reject(FrameRecord record, const std::string& reason) {
  if (lost_in_a_row++ == 0) first_lost = record.stamp;
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
  keyframe = {images.index, motion.last_pose(), true, !motion.has_velocity(),
              last_tracked.exposure};
  // Copies: otherwise the memory of the frame could not be used again.
  keyframe_images.index = images.index;
  images.color.copyTo(keyframe_images.color);
  images.depth.copyTo(keyframe_images.depth);
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

std::optional<DoubtEvidence> last_evidence(const Tracker& tracker) {
  return ExclusiveAccess(tracker.impl_, "Tracker")->evidence;
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
