// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "cvo_slam/loop/loop_detector.h"

namespace cvo_slam {

/// Consecutive keyframes that match an image: one place.
struct CandidateGroup {
  std::size_t first = 0;  ///< position of its first keyframe
  std::size_t last = 0;   ///< position of its last one
  KeyframeMatch best;
  double total_score = 0;
};

/// Groups matches, which are in ascending order of positions; those at most `gap` apart make a
/// group. The groups with the highest total score come first, the earlier of equal ones.
[[nodiscard]] std::vector<CandidateGroup> group_candidates(
    const std::vector<KeyframeMatch>& matches, std::size_t gap);

}  // namespace cvo_slam
