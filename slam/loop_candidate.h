// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cvo_slam/core/pose_graph.h"
#include "cvo_slam/loop/loop_verifier.h"

namespace cvo_slam {

/// A pair of keyframes that might constrain one another, and what became of it.
struct LoopCandidate {
  EdgeKind kind = EdgeKind::kProximity;
  std::size_t from = 0;  ///< frame index of the older keyframe
  std::size_t to = 0;    ///< frame index of the newer one
  /// Whether the newer one is a frame that was lost, and a keyframe only if this was accepted.
  bool relocalization = false;
  /// Of a place that was recognised (kLoop): how alike the words are, also as a share of what they
  /// are with the keyframe before (LoopMatch), and how many features agree with one pose.
  double score = 0;
  double normalized_score = 0;
  std::size_t inliers = 0;
  std::vector<PixelPair> pixels;  ///< of those features, a = from, b = to (Verification)
  /// By the poses of the graph, before this was tried; none where it does not connect the two.
  std::optional<double> expected_overlap;
  double overlap = 0;    ///< the lower one of the two registrations; 0 where there was none
  double cos_theta = 0;  ///< likewise
  /// How far the two registrations, one each way, are apart [m, rad].
  double round_trip_translation = 0;
  double round_trip_rotation = 0;
  /// How far the answer is from the graph's poses [m, rad, standard deviations].
  double correction_translation = 0;
  double correction_rotation = 0;
  double error = 0;
  bool accepted = false;
  std::string reason;  ///< why it was not accepted, or taken back later; empty where it is an edge
};

}  // namespace cvo_slam
