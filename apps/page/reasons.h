// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "cvo_slam/core/trajectory.h"
#include "cvo_slam/frontend/tracker.h"
#include "cvo_slam/slam/loop_candidate.h"

namespace cvo_slam {

/// A reason without its figures, by which like ones are counted together: "only 7 points" is
/// "only … points".
[[nodiscard]] std::string without_figures(std::string_view reason);

/// Consecutive frames without a pose, for like reasons.
struct LostSpan {
  std::size_t first = 0;  ///< frame index
  std::size_t last = 0;
  Timestamp stamp;        ///< of the first one
  std::size_t count = 0;  ///< less than last - first + 1 where a run takes every n-th frame
  std::string reason;     ///< the common one; without its figures where these differ
};

/// The lost frames of a trajectory in the order of the records, which have them all.
[[nodiscard]] std::vector<LostSpan> lost_spans(const std::vector<FrameRecord>& records,
                                               const std::vector<LostFrame>& lost);

/// What became of the candidates that were found in one way.
struct VerdictCount {
  std::string found_by;  ///< as in loops.csv
  std::size_t accepted = 0;
  std::size_t rejected = 0;
};

[[nodiscard]] std::vector<VerdictCount> count_verdicts(
    const std::vector<LoopCandidate>& candidates);

/// How many candidates that were found in one way were not accepted, for which reason without its
/// figures.
struct ReasonCount {
  std::string found_by;
  std::string reason;
  std::size_t count = 0;
};

/// The most frequent first, of each way.
[[nodiscard]] std::vector<ReasonCount> count_reasons(const std::vector<LoopCandidate>& candidates);

}  // namespace cvo_slam
