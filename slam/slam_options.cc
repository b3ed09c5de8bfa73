// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/slam/slam_options.h"

namespace cvo_slam {

OptionSet describe(PairOptions& o) {
  return OptionSet()
      .add("min_overlap", o.min_overlap, {0, 1}, "",
           "Least overlap of a registration. More than the tracker asks for: a graph can do "
           "without a constraint, the tracker cannot do without a frame.")
      .add("max_error", o.max_error, {0, 1e6}, "standard deviations",
           "Largest difference from the graph, in standard deviations of both. Twice what "
           "chi-square's 99 % allow, because drift is not white noise.")
      .expert()
      .add("points", o.points, {50, 100000}, "", "Points of the moving keyframe.")
      .add("skip_scales", o.skip_scales, {0, 100}, "",
           "Coarsest length scales that are left out where the start is good.")
      .add("min_cos_theta", o.min_cos_theta, {0, 1}, "",
           "Least normalised inner product, as a share of the mean of consecutive keyframes.")
      .add("max_round_trip_translation", o.max_round_trip_translation, {0, 100}, "m",
           "Largest difference of the registrations there and back. The finest kernel is 1.5 cm "
           "wide.")
      .add("max_round_trip_rotation", o.max_round_trip_rotation, {0, 4}, "rad",
           "Largest difference of the registrations there and back: 1.5 cm at a metre.");
}

OptionSet describe(ProximityOptions& o) {
  return OptionSet()
      .add("recent", o.recent, {0, 1000}, "keyframes",
           "Number of keyframes before its predecessor that a new one is registered to. They hold "
           "the drift down; with a keyframe every quarter of the field of view, the fifth has "
           "left the image.")
      .add("near", o.near, {0, 1000}, "keyframes",
           "Number of older keyframes with the largest expected overlap that a new one is "
           "registered to. Each costs two registrations.")
      .add("min_expected_overlap", o.min_expected_overlap, {0, 1}, "",
           "Least overlap by the poses of the graph for a registration to be tried. Not below "
           "pair.min_overlap, because what hides the scene is not considered.")
      .add("pair", describe(o.pair))
      .expert()
      .add("min_gap", o.min_gap, {1, 100000}, "keyframes",
           "Least distance in the sequence between two of the older keyframes: neighbours would "
           "say the same.");
}

OptionSet describe(RelocalizationOptions& o) {
  return OptionSet()
      .add("frames", o.frames, {1, 1000}, "frames",
           "Number of frames in a row that must agree before a lost camera goes on. One may show "
           "an ambiguous place.")
      .add("join_keyframes", o.join_keyframes, {1, 1000}, "keyframes",
           "Number of keyframes that must agree before two submaps are joined. They are a quarter "
           "of a view apart.")
      .expert()
      .add("min_coverage", o.min_coverage, {0, 1}, "",
           "Least share of the image's cells with matches, of those in which both images should "
           "see features.")
      .add("min_agreement", o.min_agreement, {0, 10}, "",
           "Least agreement far from where the camera was lost: twice that share, plus twice the "
           "share of matching features, plus cos_theta as a share of the usual one. Ambiguous "
           "places of the synthetic house reach 3.0, the same place 3.3 and more.")
      .add("lost_speed", o.lost_speed, {0, 1e6}, "m/s",
           "Standard deviation of the speed of a lost camera.")
      .add("lost_angular_speed", o.lost_angular_speed, {0, 1e6}, "rad/s",
           "Standard deviation of the angular speed of a lost camera.")
      .add("rival_share", o.rival_share, {0, 1}, "",
           "A second place with more than this share of the first one's coverage makes a match "
           "ambiguous.")
      .add("max_disagreement_translation", o.max_disagreement_translation, {0, 100}, "m",
           "Largest distance between where keyframes that agree put a submap.")
      .add("max_disagreement_rotation", o.max_disagreement_rotation, {0, 4}, "rad",
           "Largest angle between how keyframes that agree turn a submap.");
}

OptionSet describe(LoopClosingOptions& o) {
  return OptionSet()
      .add("enabled", o.enabled,
           "True to recognise keyframes by their images: loops and lost cameras. --mode sets it.")
      .add("detection", describe(o.detection))
      .add("pair", describe(o.pair))
      .add("max_residual", o.max_residual, {0, 1e6}, "standard deviations",
           "Largest error of a loop in the optimised graph; a loop with more is taken back.")
      .add("relocalization", describe(o.relocalization))
      .expert()
      .add("keep_rejected_matches", o.keep_rejected_matches,
           "True to keep the matching pixels of rejected candidates, for pictures of them.");
}

OptionSet describe(CullingOptions& o) {
  return OptionSet()
      .add("enabled", o.enabled,
           "True to remove keyframes for which an older one can stand in: it is within half of the "
           "limits of tracker.keyframe and sees the same. The map does not grow then in places "
           "that it has.")
      .add("max_memory", o.max_memory, {0, 1e9}, "MB",
           "Most memory of the keyframes; 0 = no limit. Beyond it, those that are nearest to "
           "others are removed, so that the map gets coarser. 50 keyframes take 6 MB.");
}

OptionSet describe(SlamOptions& o) {
  return OptionSet()
      .add("tracker", describe(o.tracker))
      .add("schedule", o.schedule,
           {{"inline", Schedule::kInline}, {"pipelined", Schedule::kPipelined}},
           "Where the work on the map is done: within track(), or in a thread of its own. Results "
           "do not depend on it.")
      .add("correction_delay", o.correction_delay, {0, 1000}, "keyframes",
           "Number of keyframes after which the online poses contain what the map has learnt from "
           "one. Fixed, so that no result depends on timing.")
      .add("optimize_every", o.optimize_every, {1, 100000}, "keyframes",
           "The newest part of the graph is optimised whenever so many keyframes were added.")
      .add("proximity", describe(o.proximity))
      .add("loops", describe(o.loops))
      .add("culling", describe(o.culling))
      .add("optimizer", describe(o.optimizer))
      .expert()
      .add("map_points", o.map_points, {50, 100000}, "",
           "Most points of a keyframe that the map keeps, of those that the tracker selects for "
           "it. Twice as many as are registered to them; more take memory and time.")
      .add("noise_translation", o.noise_translation, {0, 1}, "m",
           "Standard deviation of what a registration cannot know of its error: bent depth, "
           "inexact stamps. It is added to the covariance of every edge. By their own account the "
           "registrations of fr1/rpy's keyframes are good to 1 mm; the ground truth, with an error "
           "of its own, says 7 mm.")
      .add("noise_rotation", o.noise_rotation, {0, 1}, "rad", "The same for the rotation.");
}

}  // namespace cvo_slam
