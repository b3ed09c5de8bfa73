// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "cvo_slam/frontend/image_rotation_internal.h"
#include "cvo_slam/frontend/tracker_impl_internal.h"

namespace cvo_slam {
namespace {

/// Returns true if a registration is turned otherwise than a start by more than fine kernels reach.
bool is_turned(const Registered& registered, const SE3& T_world_start) {
  constexpr double kReach = 0.03;  // [rad]
  return (T_world_start.inverse() * registered.T_world_camera).angle() > kReach;
}

/// Replaces a registration by another one that is more similar, or that is believed.
void take_if_better(const Registered& other, Registered& registered) {
  if (!registered.is_believed() ||
      (other.is_believed() && other.result.cos_theta > registered.result.cos_theta)) {
    registered = other;
  }
}

}  // namespace

/// Returns where the camera is expected after a motion since the last tracked frame, turned as the
/// images say.
SE3 Tracker::Impl::pose_as_seen(const SE3& T_last_camera) const {
  return motion.last_pose() *
         turned_as_seen(T_last_camera, last_tracked.images.color, frame.images.color, camera.color);
}

/// True if features say that a registration is elsewhere, by more than their pose may be off.
bool Tracker::Impl::is_elsewhere(const Registered& registered) const {
  if (!starts.T_keyframe_found) return false;
  const SE3 T_found_registered =
      starts.T_keyframe_found->inverse() * registered.result.T_fixed_moving;
  return T_found_registered.translation().norm() >= 0.15 /* m */ ||
         T_found_registered.angle() >= 0.15 /* rad */;
}

/// True if a registration would be enough for a camera that was lost.
bool Tracker::Impl::is_certain(const Registered& registered) const {
  return find_fault(registered.result, situation_of(registered, true), options.lost).empty();
}

/// Does not believe a registration that is likely to be wrong, or beside which another start led to
/// an answer elsewhere that is as good, or that features contradict. As long as the last tracked
/// frame has not been asked, none that is more likely wrong than right.
void Tracker::Impl::refuse_if_doubtful(Registered& registered) const {
  if (!registered.is_believed()) return;
  find_doubt(registered);  // there may be more answers now
  LostOptions any_match = options.lost;
  any_match.min_overlap = any_match.min_cos_theta = 0;
  registered.fault = find_fault(registered.result, situation_of(registered, false), any_match);
  if (starts.found_was_refused && is_elsewhere(registered) && !is_certain(registered)) {
    registered.fault = "the features of the images say that the camera is elsewhere";
  }
  if (registered.T_keyframe_rival) {
    const SE3 T_camera_rival =
        registered.result.T_fixed_moving.inverse() * *registered.T_keyframe_rival;
    registered.fault =
        fmt::format("another pose, {:.2f} m and {:.1f} degrees away, is as similar",
                    T_camera_rival.translation().norm(), kDegrees * T_camera_rival.angle());
  }
  const double most = keyframe->is_last_tracked ? 1 : 0.5;
  const double limit = std::min(options.lost.max_doubt, most);
  if (registered.doubt <= limit) return;
  registered.fault =
      fmt::format("wrong by more than 5 cm or 3 degrees with a probability of {:.2f}, above {:.2f}",
                  registered.doubt, limit);
}

/// Does the same, and keeps what was refused, with its rival, to be tried with another keyframe.
void Tracker::Impl::refuse_for_now(Registered& registered) {
  const bool was_believed = registered.is_believed();
  refuse_if_doubtful(registered);
  if (!was_believed || registered.is_believed()) return;
  starts.T_world_refused.push_back(registered.T_world_camera);
  if (!registered.T_keyframe_rival) return;
  starts.T_world_refused.push_back(keyframe->T_world_camera * *registered.T_keyframe_rival);
}

/// Registers from the predicted pose. If that fails or is doubtful, or if the last frame is long
/// ago, also from where the images say that the camera has turned; if doubt is left, from where its
/// features say that it is. If that fails too, without the velocity, and at last to the last
/// tracked frame, the most similar one there is. That attempt makes it the keyframe, which it stays
/// even if the attempt fails. A failure also forgets the velocity. The first success with a
/// keyframe that was made without it, as at a start, makes that keyframe again.
Registered Tracker::Impl::register_frame(const StartFinder& find_start) {
  const Timestamp stamp = frame.images.stamp;
  starts.clear();
  if (stamp <= motion.last_stamp()) {
    Registered none;
    none.fault = fmt::format("its stamp is not after the stamp {} of the last tracked frame",
                             motion.last_stamp().to_string());
    return none;
  }
  const bool predict = options.prediction == Prediction::kConstantVelocity;
  const bool from_velocity = predict && motion.has_velocity();
  starts.T_predicted = motion.predict(stamp);
  Registered registered = register_from(predict ? starts.T_predicted : keyframe->T_world_camera,
                                        from_velocity ? options.recovery_scales : 0);
  // The velocity of long ago says little: a hand turns back at any time.
  if (predict && (motion.is_far(stamp) || registered.is_doubtful())) try_seen_start(registered);
  if (registered.is_doubtful()) try_found_start(find_start, registered);
  refuse_for_now(registered);
  if (!registered.is_believed() && from_velocity) {
    registered = register_from(pose_as_seen(SE3()), 0);
    refuse_for_now(registered);
  }
  if (!registered.is_believed() && !keyframe->is_last_tracked) {
    make_keyframe();
    starts.forget_keyframe();
    registered = register_from(predict ? pose_as_seen(SE3()) : motion.last_pose(), 0);
    for (const SE3& T_world_camera : starts.T_world_refused) {
      take_if_better(register_from(T_world_camera, 0), registered);
    }
    if (registered.is_doubtful()) try_found_start(find_start, registered);
    refuse_if_doubtful(registered);
    registered.promoted_keyframe = keyframe->frame;
  }
  if (registered.is_believed() && predict && keyframe->lacks_velocity) {
    registered = register_to_remade_keyframe(registered);
  }
  if (!registered.is_believed()) motion.forget_velocity();
  return registered;
}

/// Looks how the camera has turned. If the answer is doubtful or turned otherwise, or if the last
/// frame is so long ago that an acceleration of 5 m/s^2 leads out of the reach of fine kernels
/// (0.05 m), registers again with all length scales from the prediction and, if it is then still
/// turned otherwise or not believed, from there; keeps the most similar answer.
void Tracker::Impl::try_seen_start(Registered& best) {
  starts.T_seen = pose_as_seen(motion.last_pose().inverse() * starts.T_predicted);
  judge(best);
  constexpr double kShort = 0.14;  // [s]
  const bool is_short = seconds_between(motion.last_stamp(), frame.images.stamp) < kShort;
  if (is_short && !best.is_doubtful() && !is_turned(best, *starts.T_seen)) return;
  const bool was_narrow = motion.has_velocity() && options.recovery_scales > 0;
  if (was_narrow) take_if_better(register_from(starts.T_predicted, 0), best);
  if (!best.is_believed() || is_turned(best, *starts.T_seen)) {
    take_if_better(register_from(*starts.T_seen, 0), best);
  }
  judge(best);  // beside the other answers
}

/// Registers from the start that `find_start` finds. Its answer replaces `best` if it stays near
/// that start and `best` is elsewhere, because two ways to measure agree then; otherwise if it is
/// the more similar one. If its answer is not believed, nothing far from that start is that is not
/// certain (refuse_if_doubtful()).
void Tracker::Impl::try_found_start(const StartFinder& find_start, Registered& best) {
  if (!find_start) return;
  starts.features_asked = true;
  starts.T_keyframe_found = find_start(keyframe_images, keyframe->T_world_camera, frame.images);
  if (!starts.T_keyframe_found) return;
  judge(best);  // it is from before the features were asked
  Registered found =
      register_from(keyframe->T_world_camera * *starts.T_keyframe_found, options.recovery_scales);
  const auto opinion = [&](const Registered& registered) {
    return opinion_on(registered.result.T_fixed_moving, *starts.T_keyframe_found);
  };
  const bool agrees = opinion(found) == FeatureOpinion::kAgrees;
  if (!found.is_believed() && agrees) {
    // Blurred images are less similar. That two measurements agree makes up for it.
    LostOptions lenient = options.lost;
    lenient.min_cos_theta *= 0.5;
    lenient.min_overlap *= 0.67;
    found.fault = find_fault(found.result, situation_of(found, false), lenient);
  }
  const bool best_is_elsewhere = best.is_believed() && is_elsewhere(best);
  if (found.is_believed()) {
    const bool is_as_good = found.result.cos_theta > kAsGood * best.result.cos_theta;
    const bool is_better = !best.is_believed() ||
                           (agrees && (best_is_elsewhere ||
                                       (is_as_good && opinion(best) != FeatureOpinion::kAgrees))) ||
                           found.result.cos_theta > best.result.cos_theta;
    if (is_better) best = found;
  } else {
    starts.found_was_refused = true;
  }
}

/// Registers the frame in work to the keyframe from a start, and judges the result.
Registered Tracker::Impl::register_from(const SE3& T_world_camera_init, int skip) {
  const Timestamp stamp = frame.images.stamp;
  const SE3& T_world_keyframe = keyframe->T_world_camera;
  const SE3 T_init = T_world_keyframe.inverse() * T_world_camera_init;
  Registered registered;
  registered.keyframe = keyframe->frame;
  place_points(motion.velocity());
  if (has_rolling_shutter()) {
    // The predicted velocity is a frame old: undo again with the one that was found.
    const Approach approach = registration.approach(points, T_init, skip);
    place_points(motion.velocity_to(stamp, T_world_keyframe * approach.T_fixed_moving));
    registered.result = registration.refine(points, approach);
  } else {
    registered.result = registration.align(points, T_init, skip);
  }
  registered.T_world_camera = T_world_keyframe * registered.result.T_fixed_moving;
  judge(registered);
  if (registered.result.status != RegistrationStatus::kFailed) {
    const RegistrationResult& result = registered.result;
    starts.answers.push_back(
        {result.T_fixed_moving, result.covariance, result.cos_theta, registered.is_believed()});
  }
  return registered;
}

/// How far a pose is from the nearest one that is predicted.
double Tracker::Impl::nearest_surprise(const SE3& T_world_camera) const {
  const double by_velocity = surprise_of(starts.T_predicted.inverse() * T_world_camera);
  if (!starts.T_seen) return by_velocity;
  return std::min(by_velocity, surprise_of(starts.T_seen->inverse() * T_world_camera));
}

/// The cos_theta of the most similar answer elsewhere, as a share of that of a registration; 0 if
/// there is none.
double Tracker::Impl::share_of_rival(const RegistrationResult& result) const {
  double largest = 0;
  for (const Answer& answer : starts.answers) {
    if (are_apart(result.T_fixed_moving, result.covariance, answer.T_fixed_moving,
                  answer.covariance)) {
      largest = std::max(largest, answer.cos_theta);
    }
  }
  return largest > 0 ? largest / std::max(result.cos_theta, 1e-6) : 0;
}

/// Looks for another answer that is as good, and that features do not decide against.
void Tracker::Impl::find_rival(Registered& registered) const {
  registered.T_keyframe_rival.reset();
  if (registered.evidence->features == FeatureOpinion::kAgrees) return;
  double largest = 0;
  for (const Answer& answer : starts.answers) {
    if (answer.cos_theta <= largest || !is_equal_rival(answer, registered.result)) continue;
    registered.T_keyframe_rival = answer.T_fixed_moving;
    largest = answer.cos_theta;
  }
}

/// Finds the doubt of a registration that has not failed.
void Tracker::Impl::find_doubt(Registered& registered) const {
  const RegistrationResult& result = registered.result;
  const double seconds = seconds_between(motion.last_stamp(), frame.images.stamp);
  DoubtEvidence known =
      evidence_of(result, nearest_surprise(registered.T_world_camera), seconds, usual);
  known.rival = share_of_rival(result);
  if (starts.T_keyframe_found) {
    known.features = opinion_on(result.T_fixed_moving, *starts.T_keyframe_found);
  }
  registered.doubt = doubt_of(known);
  registered.evidence = known;
  find_rival(registered);
}

/// Finds the doubt of a registration and whether it is believed.
void Tracker::Impl::judge(Registered& registered) const {
  const RegistrationResult& result = registered.result;
  if (result.status != RegistrationStatus::kFailed) find_doubt(registered);
  registered.fault = find_fault(result, situation_of(registered, lost_in_a_row > 0), options.lost);
}

/// How far the frame in work would be from the last tracked one.
TrackingSituation Tracker::Impl::situation_of(const Registered& registered, bool is_lost) const {
  return {motion.last_pose().inverse() * registered.T_world_camera,
          seconds_between(motion.last_stamp(), frame.images.stamp), registered.doubt, is_lost};
}

/// The first keyframe of a submap was made before its motion was known. Makes it again with the
/// motion to the frame that was just registered to it, and registers that frame, whose points are
/// selected again too.
Registered Tracker::Impl::register_to_remade_keyframe(const Registered& first) {
  motion.set_velocity(motion.velocity_to(frame.images.stamp, first.T_world_camera));
  make_keyframe();
  select(frame, number_of_points(), seen);
  Registered registered = register_from(first.T_world_camera, options.recovery_scales);
  registered.promoted_keyframe = first.promoted_keyframe;
  registered.doubt = first.doubt;  // it is the same motion
  if (registered.result.status != RegistrationStatus::kFailed &&
      opinion_on(registered.result.T_fixed_moving, first.result.T_fixed_moving) ==
          FeatureOpinion::kAgrees) {
    registered.fault.clear();  // features may have made up for a weak match
  }
  if (registered.evidence) registered.evidence = first.evidence;
  return registered;
}

}  // namespace cvo_slam
