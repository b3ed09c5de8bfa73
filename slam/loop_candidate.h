// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cvo_slam/backend/optimizer.h"
#include "cvo_slam/core/pose_graph.h"
#include "cvo_slam/loop/loop_verifier.h"

namespace cvo_slam {

/// A pair of keyframes that might constrain one another, and what became of it: a row of loops.csv.
/// Figures that were not computed are 0.
struct LoopCandidate {
  EdgeKind kind = EdgeKind::kProximity;  ///< how the pair was found: kProximity or kLoop
  std::size_t from = 0;                  ///< number of the older keyframe
  std::size_t to = 0;                    ///< number of the newer one
  /// True if the newer one is a frame that was lost; it is a keyframe only if this was accepted.
  bool relocalization = false;
  /// Similarity of the words of the two images (kLoop).
  double score = 0;
  /// The score divided by that with the preceding keyframe, or for a lost image by the best score;
  /// the divisor is not less than `min_neighbor_score` (LoopMatch).
  double normalized_score = 0;
  std::size_t inliers = 0;  ///< features that agree with one pose (kLoop)
  /// Where they are: a = from, b = to (Verification). Empty for a candidate that was rejected for
  /// good, unless LoopClosingOptions::keep_rejected_matches.
  std::vector<PixelPair> pixels;
  /// Overlap by the poses of the graph before the pair was registered: the smaller of the two
  /// shares of points that lie in the other's image. None if the graph does not connect the two.
  std::optional<double> expected_overlap;
  double overlap = 0;    ///< the lower one of the two registrations'
  double cos_theta = 0;  ///< the lower one of the two registrations'
  /// How far the two registrations, one each way, are apart.
  double round_trip_translation = 0;  ///< [m]
  double round_trip_rotation = 0;     ///< [rad]
  /// How far the measurement is from the graph's poses.
  double correction_translation = 0;  ///< [m]
  double correction_rotation = 0;     ///< [rad]
  double error = 0;                   ///< [standard deviations]
  /// True if it is an edge, or was one until another keyframe stood in for one of the two.
  bool accepted = false;
  std::string reason;  ///< why it was not accepted, or was taken back; empty if it is an edge
};

/// What the map takes: how often the graph was optimised while it grew, how long that took, and
/// memory.
struct GraphStatistics {
  int window_solves = 0;      ///< number of optimisations of the newest part
  int full_solves = 0;        ///< number of optimisations of the whole graph
  double window_seconds = 0;  ///< wall time of all window solves
  double full_seconds = 0;    ///< wall time of all full solves
  Summary last_full;          ///< of the last optimisation of the whole graph
  /// Memory of the keyframes: their points, features, words and the index of these [bytes].
  std::size_t keyframe_bytes = 0;
  /// Number of keyframes that were removed because an older one sees the same.
  std::size_t redundant_keyframes = 0;
  /// Number of keyframes that were removed to keep within CullingOptions::max_memory.
  std::size_t dropped_keyframes = 0;
};

}  // namespace cvo_slam
