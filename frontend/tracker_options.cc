// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/frontend/tracker_options.h"

#include <fmt/format.h>

#include "cvo_slam/core/error.h"

namespace cvo_slam {

OptionSet describe(KeyframeOptions& o) {
  return OptionSet()
      .add("min_overlap", o.min_overlap, {0, 1}, "",
           "A frame of which fewer points find a partner becomes the next keyframe: less than this "
           "times what can be expected, which is the best share of the points in view that found "
           "one at the last keyframes. Where depth is missing in patches, some never do.")
      .add("max_translation", o.max_translation, {0, 100}, "m",
           "So does one further away than this, from where near things look different.")
      .add("max_rotation", o.max_rotation, {0, 4}, "rad",
           "So does one rotated by more than this: a quarter of a Kinect's field of view.");
}

OptionSet describe(LostOptions& o) {
  return OptionSet()
      .add("min_points", o.min_points, {10, 1000000}, "",
           "With fewer points in a frame six degrees of freedom are not held reliably: eight for "
           "each. Walls without texture leave about a hundred.")
      .add("min_overlap", o.min_overlap, {0, 1}, "",
           "A registration with less overlap is not believed.")
      .add("min_cos_theta", o.min_cos_theta, {0, 1}, "",
           "A registration with a smaller normalised inner product is not believed.")
      .add("max_speed", o.max_speed, {0, 1000}, "m/s",
           "No hand moves a camera faster: such a step is a wrong registration.")
      .add("max_angular_speed", o.max_angular_speed, {0, 1000}, "rad/s",
           "No hand turns a camera faster.")
      .add("restart_after", o.restart_after, {1, 1000000}, "frames",
           "After so many lost frames in a row a new segment of the trajectory is started.");
}

OptionSet describe(TrackerOptions& o) {
  return OptionSet()
      .add("reference", o.reference,
           {{"keyframe", Reference::kKeyframe}, {"previous_frame", Reference::kPreviousFrame}},
           "What a frame is registered against. A keyframe does not add up the errors of the "
           "frames between.")
      .add("prediction", o.prediction,
           {{"constant_velocity", Prediction::kConstantVelocity},
            {"identity", Prediction::kIdentity}},
           "Where a registration starts. Hands and robots move smoothly at 30 Hz.")
      .add("recovery_scales", o.recovery_scales, {0, 100}, "",
           "So many of the coarsest length scales are left out where the pose was predicted, and "
           "serve where a registration without them failed: wide kernels reach further, but pull "
           "towards dense regions, away from a prediction that was good.")
      .add("points", o.points, {50, 100000}, "",
           "Points of a frame. Twice as many cost twice the time and gain nothing.")
      .add("keyframe_points", o.keyframe_points, {50, 100000}, "",
           "Points of a keyframe. More than of a frame, so that most points of a frame find the "
           "very same place.")
      .add("compensate_depth_delay", o.compensate_depth_delay,
           "Takes the camera's predicted motion between the stamps of the colour and the depth "
           "image out of the points: sensors without a common clock take them up to 17 ms apart.")
      .add("compensate_rolling_shutter", o.compensate_rolling_shutter,
           "Takes the camera's motion while its rows were read (Camera::readout_time) out of the "
           "points.")
      .add(
          "compensate_exposure", o.compensate_exposure,
          "Scales the colours of a frame back where all of its image has become brighter or darker "
          "by one factor, of more than 15 %, since the frame before.")
      .add("threads", o.threads, {1, 1024}, "",
           "Threads of one registration. Results do not depend on it.")
      .add("selection", describe(o.selection))
      .add("registration", describe(o.registration))
      .add("keyframe", describe(o.keyframe))
      .add("lost", describe(o.lost));
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
  o.registration.length_scales = {0.15, 0.10, 0.06, 0.03};
  o.registration.max_iterations = {3, 7, 10, 1000};
  return o;
}

}  // namespace cvo_slam
