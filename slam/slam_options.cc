// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/slam/slam_options.h"

namespace cvo_slam {

OptionSet describe(PairOptions& o) {
  return OptionSet()
      .add("points", o.points, {50, 100000}, "",
           "Points of the moving keyframe, as of a frame that is tracked.")
      .add("skip_scales", o.skip_scales, {0, 100}, "",
           "So many of the coarsest length scales are left out, where the start is a good one.")
      .add("min_overlap", o.min_overlap, {0, 1}, "",
           "A registration with less overlap is not believed: what the points without a partner "
           "would have said is missing, and the sensor's errors are not the same in two views that "
           "differ. More than the tracker asks for: a constraint can be done without, a frame "
           "cannot.")
      .add("min_cos_theta", o.min_cos_theta, {0, 1}, "",
           "Nor is one whose normalised inner product is less than this share of the usual, the "
           "mean of the keyframes' with their predecessors.")
      .add("max_round_trip_translation", o.max_round_trip_translation, {0, 100}, "m",
           "Each pair is registered both ways. Further apart than this the two answers are not "
           "believed: the finest kernel is 1.5 cm wide.")
      .add("max_round_trip_rotation", o.max_round_trip_rotation, {0, 4}, "rad",
           "The same for the rotation: 1.5 cm at a metre.")
      .add("max_error", o.max_error, {0, 1e6}, "",
           "An answer that differs from the graph by more standard deviations (of the graph along "
           "its most certain path, and of the registration) than this is not believed. Twice what "
           "chi-square's 99 % allow, for drift is not white: with 4 the registrations that correct "
           "the drift of fr1/rpy are among those refused, and its ATE is 0.037 m, not 0.017.");
}

OptionSet describe(ProximityOptions& o) {
  return OptionSet()
      .add("recent", o.recent, {0, 1000}, "keyframes",
           "A new keyframe is registered to so many before its predecessor. They are what holds "
           "the drift down; at a keyframe each quarter of the field of view, the fifth has left "
           "the image.")
      .add("near", o.near, {0, 1000}, "keyframes",
           "And to so many of the older ones that see the same. Each costs two registrations.")
      .add("min_gap", o.min_gap, {1, 100000}, "keyframes",
           "Of the older ones no two are closer in the sequence than this: neighbours saw the same "
           "from the same place and would say the same.")
      .add("min_expected_overlap", o.min_expected_overlap, {0, 1}, "",
           "The share of either keyframe's points that must lie in the other's image, by the "
           "graph's poses, for a registration to be tried. Things in between are not looked for, "
           "so that this is no less than pair.min_overlap.")
      .add("pair", describe(o.pair));
}

OptionSet describe(RelocalizationOptions& o) {
  return OptionSet()
      .add(
          "min_likely_coverage", o.min_likely_coverage, {0, 1}, "",
          "Of the cells of the image in which both images should see features, the share that must "
          "have some that match, where the camera can have come to since it was lost.")
      .add(
          "min_likeness", o.min_likeness, {0, 10}, "",
          "Elsewhere, where there may be look-alikes: twice that share, plus twice the share of "
          "matches among the features that both images should see, plus the registration's "
          "cos_theta as a share of the usual. Look-alikes of `house` reach 3.0; of the same place, "
          "with most of the view in common, 3.3 and more.")
      .add("lost_speed", o.lost_speed, {0, 1e6}, "m/s",
           "Standard deviation of the speed of a lost camera.")
      .add("lost_angular_speed", o.lost_angular_speed, {0, 1e6}, "rad/s",
           "The same for its angular speed. With these a second without tracking leaves open where "
           "the camera is.")
      .add("rival_share", o.rival_share, {0, 1}, "",
           "A second place that covers more than this share of what the first one covers leaves "
           "open which it is.")
      .add("frames", o.frames, {1, 1000}, "",
           "A lost camera goes on when so many frames agree on where it is.")
      .add(
          "join_keyframes", o.join_keyframes, {1, 1000}, "",
          "A part of the graph is joined with another when so many keyframes agree on where it is. "
          "They are a quarter of a view apart, so that this is some way.")
      .add("max_disagreement_translation", o.max_disagreement_translation, {0, 100}, "m",
           "How far keyframes that agree may put each other: both parts may have drifted between. "
           "Places that look alike are metres apart.")
      .add("max_disagreement_rotation", o.max_disagreement_rotation, {0, 4}, "rad",
           "The same for the rotation.");
}

OptionSet describe(LoopClosingOptions& o) {
  return OptionSet()
      .add("enabled", o.enabled,
           "Whether keyframes are looked for that show the place of the newest one, wherever the "
           "graph has them. The program's --mode decides.")
      .add("detection", describe(o.detection))
      .add("pair", describe(o.pair))
      .add("max_residual", o.max_residual, {0, 1e6}, "",
           "A loop that the optimised graph contradicts by more of its own standard deviations is "
           "taken back.")
      .add("relocalization", describe(o.relocalization));
}

OptionSet describe(SlamOptions& o) {
  return OptionSet()
      .add("schedule", o.schedule,
           {{"inline", Schedule::kInline}, {"pipelined", Schedule::kPipelined}},
           "Where the map's work is done: within track(), or in a thread of its own. Results do "
           "not depend on it.")
      .add("correction_delay", o.correction_delay, {0, 1000}, "keyframes",
           "What the map has learnt from a keyframe is applied to the poses that track() answers "
           "when so many more keyframes have been made: a fixed number, so that no result depends "
           "on timing. A keyframe's work takes less time than two of them are apart.")
      .add("optimize_every", o.optimize_every, {1, 100000}, "keyframes",
           "The newest part of the graph is optimised when so many keyframes have been added.")
      .add("noise_translation", o.noise_translation, {0, 1}, "m",
           "Standard deviation of what a registration cannot know of its error, and that is added "
           "to what it says: depth that is bent, stamps that are not exact, a shutter that rolls. "
           "By their own account those of fr1/rpy's keyframes are good to 1 mm; the ground truth "
           "says 7 mm, part of which is its own.")
      .add("noise_rotation", o.noise_rotation, {0, 1}, "rad", "The same for the rotation.")
      .add("proximity", describe(o.proximity))
      .add("loops", describe(o.loops))
      .add("optimizer", describe(o.optimizer));
}

}  // namespace cvo_slam
