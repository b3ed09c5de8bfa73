// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/frontend/tracker.h"

namespace cvo_slam {

OptionSet describe(KeyframeOptions& o) {
  return OptionSet()
      .add("min_overlap", o.min_overlap, {0, 1}, "",
           "A tracked frame with less overlap than this share of the expected one becomes the next "
           "keyframe. The expected overlap is the best one of the last keyframes.")
      .add("max_translation", o.max_translation, {0, 100}, "m",
           "A tracked frame further away from the keyframe than this becomes the next keyframe.")
      .add("max_rotation", o.max_rotation, {0, 4}, "rad",
           "A tracked frame rotated by more than this against the keyframe becomes the next "
           "keyframe. The default is a quarter of a Kinect's field of view.");
}

OptionSet describe(LostOptions& o) {
  return OptionSet()
      .add("min_points", o.min_points, {10, 1000000}, "",
           "Least number of points of a frame. Six degrees of freedom need eight points each.")
      .add("min_overlap", o.min_overlap, {0, 1}, "",
           "Least overlap of a registration; two thirds of it where features agree.")
      .add(
          "max_speed", o.max_speed, {0, 1000}, "m/s",
          "Largest speed of the camera that is believed where the doubt is above 0.02. The default "
          "is more than a hand can do.")
      .add(
          "max_angular_speed", o.max_angular_speed, {0, 1000}, "rad/s",
          "Largest angular speed of the camera that is believed where the doubt is above 0.02. The "
          "default is more than a hand can do.")
      .add("max_doubt", o.max_doubt, {0, 1}, "",
           "Largest probability that the pose is wrong by more than 5 cm or 3 degrees; 1 = any. "
           "Lower it where a wrong pose is worse than none. Above 0.5 the last tracked frame is "
           "asked in place of the keyframe.")
      .add("restart_time", o.restart_time, {0, 1e6}, "s",
           "Time from the first lost frame on after which a new submap starts.")
      .expert()
      .add("min_cos_theta", o.min_cos_theta, {0, 1}, "",
           "Least normalised inner product of the clouds after a registration; half of it where "
           "features agree.")
      .add("restart_frames", o.restart_frames, {1, 1000000}, "frames",
           "Number of lost frames before which no new submap starts, however long they take.");
}

OptionSet describe(TrackerOptions& o) {
  return OptionSet()
      .add("points", o.points, {50, 100000}, "",
           "Number of points of a frame. Twice as many cost twice the time and gain nothing at 30 "
           "frames a second; they are taken more than 0.05 s after the last tracked frame, with "
           "the constant_velocity prediction.")
      .add("keyframe_points", o.keyframe_points, {50, 100000}, "",
           "Number of points of a keyframe: more than of a frame, so that most points of a frame "
           "find the very same spot of a surface.")
      .add("threads", o.threads, {1, 1024}, "",
           "Number of threads of one registration. Results do not depend on it.")
      .add("compensate_depth_delay", o.compensate_depth_delay,
           "Takes the predicted motion between the stamps of the colour and the depth image out of "
           "the points. Sensors without a common clock take the two up to 17 ms apart.")
      .add("compensate_rolling_shutter", o.compensate_rolling_shutter,
           "Takes the motion while the rows were read (the camera's readout_time) out of the "
           "points.")
      .add("compensate_exposure", o.compensate_exposure,
           "Scales the colours of a frame back where the whole image has become brighter or darker "
           "by one factor, of more than 15 %, since the frame before.")
      .add("selection", describe(o.selection))
      .add("registration", describe(o.registration))
      .add("keyframe", describe(o.keyframe))
      .add("lost", describe(o.lost))
      .expert()
      .add("reference", o.reference,
           {{"keyframe", Reference::kKeyframe}, {"previous_frame", Reference::kPreviousFrame}},
           "What a frame is registered to. A keyframe does not add up the errors of the frames "
           "between; the paper takes the previous frame.")
      .add("prediction", o.prediction,
           {{"constant_velocity", Prediction::kConstantVelocity},
            {"identity", Prediction::kIdentity}},
           "Where a registration starts: at the pose predicted by a constant velocity, or at the "
           "keyframe's own as in the paper.")
      .add(
          "recovery_scales", o.recovery_scales, {0, 100}, "",
          "Number of the coarsest length scales that serve only where a prediction is not trusted: "
          "after a failed or doubtful registration, a turn that it did not know of, or 0.14 s. "
          "Wide "
          "kernels reach further, but pull towards dense regions, away from a good prediction.");
}

void check_consistency(const TrackerOptions& options) {
  check_consistency(options.registration);
  const auto& selection = options.selection;
  if (selection.min_depth < selection.max_depth) return;
  throw OptionError(fmt::format("selection.min_depth={} must be less than selection.max_depth={}",
                                selection.min_depth, selection.max_depth));
}

TrackerOptions paper_options() {
  TrackerOptions o;
  o.reference = Reference::kPreviousFrame;
  o.prediction = Prediction::kIdentity;
  o.compensate_depth_delay = o.compensate_rolling_shutter = o.compensate_exposure = false;
  o.points = o.keyframe_points = 3000;
  o.selection.method = SelectionMethod::kEdges;
  o.registration.solver = Solver::kFlow;
  o.registration.coarser_share = 1;
  o.registration.kernel.color_kernel = ColorKernel::kLinear;
  o.registration.judged_length_scale = 0.03;
  o.registration.length_scales = {0.15, 0.10, 0.06, 0.03};
  o.registration.max_iterations = {3, 7, 10, 1000};
  return o;
}

}  // namespace cvo_slam
