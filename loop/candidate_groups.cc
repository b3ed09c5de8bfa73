// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "cvo_slam/loop/candidate_groups_internal.h"

namespace cvo_slam {

std::vector<CandidateGroup> group_candidates(const std::vector<KeyframeMatch>& matches,
                                             std::size_t gap) {
  std::vector<CandidateGroup> groups;
  for (const KeyframeMatch& match : matches) {
    if (groups.empty() || match.keyframe > groups.back().last + gap) {
      groups.push_back({match.keyframe, match.keyframe, match, match.score});
      continue;
    }
    CandidateGroup& group = groups.back();
    group.last = match.keyframe;
    group.total_score += match.score;
    if (match.score > group.best.score) group.best = match;
  }
  std::stable_sort(groups.begin(), groups.end(),
                   [](const CandidateGroup& a, const CandidateGroup& b) {
                     return a.total_score > b.total_score;
                   });
  return groups;
}

}  // namespace cvo_slam
