// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/frontend/tracker.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "cvo_slam/frontend/brightness_internal.h"
#include "cvo_slam/frontend/motion_model_internal.h"
#include "cvo_slam/frontend/rolling_shutter_internal.h"
#include "cvo_slam/frontend/visible_share.h"

namespace cvo_slam {
namespace {

/// How much the share of points that can be expected to find a partner falls with each keyframe,
/// unless it is found again: a fast turn is over, and holes in the depth are noticed, after some
/// ten.
constexpr double kForgetting = 0.02;

void scale_colors(double factor, PointCloud& cloud) {
  if (factor == 1) return;
  for (auto& feature : cloud.features) {
    for (float& value : feature) value *= static_cast<float>(factor);
  }
}

/// Why a registration is not believed; empty where it is.
std::string find_fault(const RegistrationResult& result, const LostOptions& limits) {
  if (result.status == RegistrationStatus::kFailed) return result.reason;
  if (result.overlap < limits.min_overlap) {
    return fmt::format("overlap {:.2f} is below {:.2f}", result.overlap, limits.min_overlap);
  }
  if (result.cos_theta < limits.min_cos_theta) {
    return fmt::format("cos_theta {:.2f} is below {:.2f}", result.cos_theta, limits.min_cos_theta);
  }
  return {};
}

/// A lost camera may be anywhere, the longer the more, and any view has something that resembles
/// the keyframe: more must agree.
LostOptions limits_of_lost(double seconds, LostOptions limits) {
  constexpr double kLong = 0.5;  // [s]
  const double factor = seconds > kLong ? 2 : 1.5;
  limits.min_overlap = std::min(1.0, factor * limits.min_overlap);
  limits.min_cos_theta = std::min(1.0, factor * limits.min_cos_theta);
  return limits;
}

/// Why the camera cannot have moved from `a` to `b` in `seconds`; empty where it can.
std::string find_motion_fault(const SE3& a, const SE3& b, double seconds,
                              const LostOptions& limits) {
  const SE3 motion = a.inverse() * b;
  const double speed = motion.translation().norm() / seconds;
  const double angular_speed = motion.angle() / seconds;
  if (speed > limits.max_speed) {
    return fmt::format("speed {:.1f} m/s is above {:.1f}", speed, limits.max_speed);
  }
  if (angular_speed > limits.max_angular_speed) {
    return fmt::format("angular speed {:.1f} rad/s is above {:.1f}", angular_speed,
                       limits.max_angular_speed);
  }
  return {};
}

/// Why a tracked frame shall become a keyframe; empty where it need not.
/// `found_share` is what part of the points in view can be expected to find a partner.
std::string keyframe_reason(const RegistrationResult& result, double found_share,
                            const KeyframeOptions& options) {
  if (result.overlap < options.min_overlap * found_share) return "overlap";
  if (result.T_fixed_moving.translation().norm() > options.max_translation) return "translation";
  if (result.T_fixed_moving.angle() > options.max_rotation) return "rotation";
  return {};
}

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

struct Tracker::Impl {
  Impl(const Camera& camera_in, const TrackerOptions& options_in)
      : camera(camera_in),
        options(checked(options_in)),
        selector(checked(camera), options.selection),
        registration(options.registration, options.threads) {}

  Camera camera;
  TrackerOptions options;
  PointSelector selector;
  PointCloud seen;            // the points of a frame as its rows saw them
  PointCloud cloud;           // at its stamp
  PointCloud frame_in_work;   // memory
  Registration registration;  // against the current keyframe
  KeyframeObserver observer;
  MotionModel motion;
  BrightnessLevel brightness;
  double last_tracked_brightness = 1;
  std::optional<std::size_t> keyframe;  // its index
  SE3 T_world_keyframe;
  RgbdFrame last_tracked;
  bool keyframe_is_last_tracked = false;
  bool keyframe_lacks_velocity = false;
  int segment = 0;
  int lost_in_a_row = 0;
  double found_share = 0;  // of the points in view those that can be expected to find a partner

  [[nodiscard]] FrameRecord record_of(const RgbdFrame& frame) const;
  void track(const RgbdFrame& frame, FrameRecord& record);
  void resume(const RgbdFrame& frame, const SE3& T_world_camera, FrameRecord& record);
  [[nodiscard]] std::string prepare(const RgbdFrame& frame, FrameRecord& record);
  void start_segment(const RgbdFrame& frame, const SE3& T_world_camera, FrameRecord& record);
  void select(const RgbdFrame& frame, int count);
  void undo_shutter(const Vector6& velocity);
  [[nodiscard]] bool has_rolling_shutter() const {
    return options.compensate_rolling_shutter && camera.readout_time > 0;
  }
  void set_keyframe(const RgbdFrame& frame, const SE3& T_world_camera);
  void remember(const RgbdFrame& frame);
  std::string register_frame(const RgbdFrame& frame, FrameRecord& record);
  std::string register_from(const SE3& T_world_camera_init, int skip, FrameRecord& record);
  std::string register_to_first_keyframe(const RgbdFrame& frame, FrameRecord& record);
  void promote_last_tracked();
  void measure_found_share(const RegistrationResult& result);
  void accept(const RgbdFrame& frame, FrameRecord& record);
  void reject(const std::string& reason, FrameRecord& record);
};

FrameRecord Tracker::Impl::record_of(const RgbdFrame& frame) const {
  FrameRecord record;
  record.index = frame.index;
  record.stamp = frame.stamp;
  record.segment = segment;
  return record;
}

/// Makes the frame that the selector is prepared for the keyframe.
void Tracker::Impl::set_keyframe(const RgbdFrame& frame, const SE3& T_world_camera) {
  keyframe = frame.index;
  found_share -= kForgetting;
  keyframe_is_last_tracked = true;
  keyframe_lacks_velocity = !motion.is_moving();
  T_world_keyframe = T_world_camera;
  select(frame, options.keyframe_points);
  undo_shutter(motion.velocity());
  registration.set_fixed(cloud);
  if (observer) observer(frame, cloud);
}

/// Keeps a copy of the images: the caller may grab the next ones into the same memory.
void Tracker::Impl::remember(const RgbdFrame& frame) {
  keyframe_is_last_tracked = false;
  cv::Mat color = last_tracked.color;
  cv::Mat depth = last_tracked.depth;
  frame.color.copyTo(color);
  frame.depth.copyTo(depth);
  last_tracked = frame;
  last_tracked.color = color;
  last_tracked.depth = depth;
  last_tracked_brightness = brightness.factor();
}

/// The points of the prepared frame, with the motion between its two images and jumps of the
/// exposure taken out.
void Tracker::Impl::select(const RgbdFrame& frame, int count) {
  // A longer delay is a depth stamp that was not set.
  constexpr double kMaxDelay = 0.1;  // [s]
  const double delay = seconds_between(frame.stamp, frame.depth_stamp);
  const bool compensate = options.compensate_depth_delay && std::abs(delay) < kMaxDelay;
  const SE3 T_color_depth = compensate ? motion.motion(frame.stamp, frame.depth_stamp) : SE3();
  selector.select(count, T_color_depth, seen);
  const bool is_last_tracked = frame.stamp == last_tracked.stamp;
  scale_colors(1 / (is_last_tracked ? last_tracked_brightness : brightness.factor()), seen);
}

/// Makes `cloud` from the points seen, with the motion while the rows were read taken out.
void Tracker::Impl::undo_shutter(const Vector6& velocity) {
  cloud = seen;
  if (!has_rolling_shutter()) return;
  undo_rolling_shutter(seen, velocity, camera.readout_time, camera.color.height, cloud);
}

void Tracker::Impl::start_segment(const RgbdFrame& frame, const SE3& T_world_camera,
                                  FrameRecord& record) {
  lost_in_a_row = 0;
  record.status = TrackingStatus::kTracked;
  record.T_world_camera = T_world_camera;
  record.keyframe = frame.index;
  record.keyframe_reason = "start of a segment";
  record.registration = {};
  record.registration.status = RegistrationStatus::kConverged;
  record.registration.reason = "the keyframe itself";
  record.registration.overlap = 1;
  record.registration.cos_theta = 1;
  motion.update(frame.stamp, record.T_world_camera);
  motion.stop();  // from wherever it was before, the camera did not move here
  remember(frame);
  selector.prepare(frame);
  set_keyframe(frame, record.T_world_camera);
}

/// Registers against the keyframe from a start; returns what is wrong with the result, or nothing.
std::string Tracker::Impl::register_from(const SE3& T_world_camera_init, int skip,
                                         FrameRecord& record) {
  record.keyframe = *keyframe;
  undo_shutter(motion.velocity());
  const SE3 T_init = T_world_keyframe.inverse() * T_world_camera_init;
  if (has_rolling_shutter()) {
    // The predicted velocity is a frame old: undo again with the one that was found.
    const Approach approach = registration.approach(cloud, T_init, skip);
    undo_shutter(motion.velocity_to(record.stamp, T_world_keyframe * approach.T_fixed_moving));
    record.registration = registration.refine(cloud, approach);
  } else {
    record.registration = registration.align(cloud, T_init, skip);
  }
  record.T_world_camera = T_world_keyframe * record.registration.T_fixed_moving;
  const double seconds = seconds_between(motion.last_stamp(), record.stamp);
  const bool is_lost = lost_in_a_row > 0;
  std::string fault = find_fault(record.registration,
                                 is_lost ? limits_of_lost(seconds, options.lost) : options.lost);
  if (!fault.empty()) return fault;
  return find_motion_fault(motion.last_pose(), record.T_world_camera, seconds, options.lost);
}

/// Registers from the predicted pose; where that fails with all length scales; where that fails too
/// without the velocity; and at last against the last tracked frame, the most similar view there
/// is.
std::string Tracker::Impl::register_frame(const RgbdFrame& frame, FrameRecord& record) {
  if (record.stamp <= motion.last_stamp()) {
    return fmt::format("its stamp is not after the stamp {} of the last tracked frame",
                       motion.last_stamp().to_string());
  }
  const bool predict = options.prediction == Prediction::kConstantVelocity;
  const bool moving = predict && motion.is_moving();
  const int skip = moving ? options.recovery_scales : 0;
  const SE3 T_init = predict ? motion.predict(record.stamp) : T_world_keyframe;
  std::string fault = register_from(T_init, skip, record);
  if (!fault.empty() && skip > 0) fault = register_from(T_init, 0, record);
  if (!fault.empty() && moving) fault = register_from(motion.last_pose(), 0, record);
  if (!fault.empty() && !keyframe_is_last_tracked) {
    promote_last_tracked();
    record.promoted_keyframe = last_tracked.index;
    fault = register_from(motion.last_pose(), 0, record);
  }
  if (fault.empty() && predict && keyframe_lacks_velocity) {
    fault = register_to_first_keyframe(frame, record);
  }
  if (!fault.empty()) motion.stop();
  return fault;
}

/// Makes the last tracked frame the keyframe; keeps the points of the frame in work.
void Tracker::Impl::promote_last_tracked() {
  frame_in_work = seen;
  selector.prepare(last_tracked);
  set_keyframe(last_tracked, motion.last_pose());
  seen = frame_in_work;
}

/// The first keyframe of a segment was made before its motion was known. Makes it again with the
/// motion to the frame that was just registered to it, and registers that one, made again too.
std::string Tracker::Impl::register_to_first_keyframe(const RgbdFrame& frame, FrameRecord& record) {
  motion.assume(motion.velocity_to(record.stamp, record.T_world_camera));
  promote_last_tracked();
  selector.prepare(frame);
  select(frame, options.points);
  return register_from(record.T_world_camera, options.recovery_scales, record);
}

/// Where depth is missing in patches that differ from image to image, a part of the points never
/// has a partner; that is no reason for a new keyframe, which would be no better.
void Tracker::Impl::measure_found_share(const RegistrationResult& result) {
  const double visible = visible_share(cloud, result.T_fixed_moving, camera.color);
  if (visible > 0) found_share = std::max(found_share, std::min(1.0, result.overlap / visible));
}

void Tracker::Impl::accept(const RgbdFrame& frame, FrameRecord& record) {
  lost_in_a_row = 0;
  record.status = TrackingStatus::kTracked;
  motion.update(frame.stamp, record.T_world_camera);
  remember(frame);
  if (options.reference == Reference::kPreviousFrame) {
    record.keyframe_reason = "previous frame";
  } else {
    measure_found_share(record.registration);
    record.keyframe_reason = keyframe_reason(record.registration, found_share, options.keyframe);
  }
  if (record.keyframe_reason.empty()) return;
  if (record.promoted_keyframe) selector.prepare(frame);
  set_keyframe(frame, record.T_world_camera);
}

void Tracker::Impl::reject(const std::string& reason, FrameRecord& record) {
  ++lost_in_a_row;
  record.status = TrackingStatus::kLost;
  record.reason = reason;
}

/// Selects the frame's points; returns why that cannot be done, or nothing.
std::string Tracker::Impl::prepare(const RgbdFrame& frame, FrameRecord& record) {
  std::string problem = check_images(frame, camera);
  if (!problem.empty()) return problem;
  if (options.compensate_exposure) brightness.update(frame.color);
  selector.prepare(frame);
  select(frame, options.points);
  record.points = seen.size();
  if (seen.size() >= static_cast<std::size_t>(options.lost.min_points)) return {};
  return fmt::format("only {} points with gradient and depth", seen.size());
}

void Tracker::Impl::track(const RgbdFrame& frame, FrameRecord& record) {
  const std::string problem = prepare(frame, record);
  if (!problem.empty()) return reject(problem, record);
  if (!keyframe) return start_segment(frame, motion.last_pose(), record);

  const std::string fault = register_frame(frame, record);
  if (fault.empty()) return accept(frame, record);
  reject(fault, record);
  if (lost_in_a_row >= options.lost.restart_after) {
    record.reason.clear();
    record.segment = ++segment;
    start_segment(frame, motion.last_pose(), record);
  }
}

void Tracker::Impl::resume(const RgbdFrame& frame, const SE3& T_world_camera, FrameRecord& record) {
  record.reason = prepare(frame, record);
  if (!record.reason.empty()) return;
  record.segment = ++segment;
  start_segment(frame, T_world_camera, record);
}

Tracker::Tracker(const Camera& camera, const TrackerOptions& options)
    : impl_(std::make_unique<Impl>(camera, options)) {}

Tracker::~Tracker() = default;
Tracker::Tracker(Tracker&&) noexcept = default;
Tracker& Tracker::operator=(Tracker&&) noexcept = default;

void Tracker::observe_keyframes(KeyframeObserver observer) {
  impl_->observer = std::move(observer);
}

FrameRecord Tracker::track(const RgbdFrame& frame) {
  FrameRecord record = impl_->record_of(frame);
  impl_->track(frame, record);
  return record;
}

FrameRecord Tracker::resume(const RgbdFrame& frame, const SE3& T_world_camera) {
  FrameRecord record = impl_->record_of(frame);
  impl_->resume(frame, T_world_camera, record);
  return record;
}

Trajectory to_trajectory(const std::vector<FrameRecord>& records) {
  std::map<int, std::size_t> frames_of_segment;
  for (const auto& record : records) {
    if (record.status == TrackingStatus::kTracked) ++frames_of_segment[record.segment];
  }
  const auto main =
      std::max_element(frames_of_segment.begin(), frames_of_segment.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });

  Trajectory trajectory;
  for (const auto& record : records) {
    if (record.status == TrackingStatus::kLost) {
      trajectory.lost.push_back({record.stamp, record.reason});
    } else if (record.segment == main->first) {
      trajectory.poses.push_back({record.stamp, record.T_world_camera});
    } else {
      trajectory.lost.push_back(
          {record.stamp, fmt::format("segment {} is not connected to the trajectory's segment {}",
                                     record.segment, main->first)});
    }
  }
  return trajectory;
}

}  // namespace cvo_slam
