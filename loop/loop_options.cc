// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/loop/loop_options.h"

namespace cvo_slam {

OptionSet describe(MatchingOptions& o) {
  return OptionSet()
      .add("node_level", o.node_level, {0, 16}, "levels",
           "Features are compared where they share the vocabulary's node so far below the root.")
      .add("max_distance", o.max_distance, {0, 256}, "bits",
           "Descriptors that differ in more are not of the same point.")
      .add("ratio", o.ratio, {0, 1}, "",
           "The nearest descriptor must be nearer than this times the second nearest.")
      .add("rotation_window", o.rotation_window, {0, 3.15}, "rad",
           "By how much a match may turn otherwise than most do.")
      .add("search_radius", o.search_radius, {0, 1000}, "px",
           "How far from where a pose says that a point is its feature is looked for, at the "
           "pyramid's finest level.");
}

OptionSet describe(VerificationOptions& o) {
  return OptionSet()
      .add("matching", describe(o.matching))
      .add("min_matches", o.min_matches, {3, 100000}, "",
           "With fewer matches no pose is looked for.")
      .add("iterations", o.iterations, {1, 1000000}, "",
           "Most triples of matches from which a pose is made.")
      .add("max_reprojection", o.max_reprojection, {0.1, 100}, "px",
           "How far an inlier is from where the pose says, at the pyramid's finest level.")
      .add("pixel_noise", o.pixel_noise, {0.01, 100}, "px",
           "Standard deviation of where a corner is found, at the finest level.")
      .add("depth_noise", o.depth_noise, {1e-5, 1}, "m",
           "Standard deviation of a depth of up to a metre; beyond, it grows with the square.")
      .add("min_inliers", o.min_inliers, {4, 100000}, "", "With fewer a pose is not believed.")
      .add("min_visible_share", o.min_visible_share, {0, 1}, "",
           "Nor with fewer of the features that both images should see by the pose.")
      .add("min_coverage", o.min_coverage, {0, 1}, "",
           "Nor where inliers are missing in more of the cells (10 by 8) in which both should see "
           "features: what is alike may be a poster alone.")
      .add("max_deviation_translation", o.max_deviation_translation, {0, 100}, "m",
           "Nor where the inliers leave the position more uncertain in any direction.")
      .add("max_deviation_rotation", o.max_deviation_rotation, {0, 4}, "rad",
           "Nor the orientation.")
      .add("seed", o.seed, {0, 1000000000}, "",
           "Of the search, together with the ids of the two images.");
}

OptionSet describe(CandidateOptions& o) {
  return OptionSet()
      .add("min_gap", o.min_gap, {0, 1000000}, "keyframes",
           "The newest keyframes are not looked for: they show the same because little has "
           "happened since, and the tracker knows them.")
      .add("min_score", o.min_score, {0, 1}, "",
           "Share of the score with the preceding keyframe that a candidate needs.")
      .add("min_neighbor_score", o.min_neighbor_score, {0, 1}, "",
           "The score with the preceding keyframe counts as no less: after a fast turn it is no "
           "measure.")
      .add("group_gap", o.group_gap, {1, 1000}, "keyframes",
           "Candidates that follow one another at no more than this distance are one place.")
      .add("candidates", o.candidates, {1, 1000}, "", "Most places to verify for an image.")
      .add("min_consistency", o.min_consistency, {0, 1000}, "images",
           "A place is verified where so many images in a row before led to it as well.");
}

OptionSet describe(LoopOptions& o) {
  return OptionSet()
      .add("orb", describe(o.orb))
      .add("candidates", describe(o.candidates))
      .add("verification", describe(o.verification));
}

}  // namespace cvo_slam
