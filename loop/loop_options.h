// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cvo_slam/core/options.h"
#include "cvo_slam/loop/orb_features.h"

namespace cvo_slam {

/// How features of two images find one another.
struct MatchingOptions {
  int node_level = 1;
  int max_distance = 64;
  double ratio = 0.85;
  double rotation_window = 0.35;
  double search_radius = 8;
};

/// How a candidate is proved.
struct VerificationOptions {
  MatchingOptions matching;
  int min_matches = 12;
  int iterations = 500;
  double max_reprojection = 3;
  double pixel_noise = 1;
  double depth_noise = 0.003;
  int min_inliers = 25;
  double min_visible_share = 0.1;
  double min_coverage = 0.4;
  double max_deviation_translation = 0.02;
  double max_deviation_rotation = 0.015;
  int seed = 1;
};

/// Which keyframes become candidates.
struct CandidateOptions {
  int min_gap = 15;
  double min_score = 0.3;
  double min_neighbor_score = 0.05;
  int group_gap = 3;
  int candidates = 3;
  int min_consistency = 0;
};

struct LoopOptions {
  OrbOptions orb;
  CandidateOptions candidates;
  VerificationOptions verification;
};

[[nodiscard]] OptionSet describe(MatchingOptions& options);
[[nodiscard]] OptionSet describe(VerificationOptions& options);
[[nodiscard]] OptionSet describe(CandidateOptions& options);
[[nodiscard]] OptionSet describe(LoopOptions& options);

}  // namespace cvo_slam
