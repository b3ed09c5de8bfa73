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

/// Returns a reason without its figures, so that equal ones can be counted together: "only 7
/// points" becomes "only … points".
[[nodiscard]] std::string without_figures(std::string_view reason);

/// Consecutive frames without a pose, for reasons that differ only in their figures.
struct LostSpan {
  std::size_t first = 0;  ///< frame index
  std::size_t last = 0;
  Timestamp stamp;        ///< stamp of the first frame
  std::size_t count = 0;  ///< number of frames; fewer than last - first + 1 if a run skips frames
  std::string reason;     ///< the common reason, without its figures if they differ
  std::string first_reason;  ///< that of the first frame, with its figures
};

/// Groups the lost frames of a trajectory, in the order of the records, which include them all.
[[nodiscard]] std::vector<LostSpan> lost_spans(const std::vector<FrameRecord>& records,
                                               const std::vector<LostFrame>& lost);

/// The verdicts on the candidates that were found in one way.
struct VerdictCount {
  std::string found_by;  ///< as in loops.csv
  std::size_t accepted = 0;
  std::size_t rejected = 0;
};

/// Counts the verdicts of each way of finding.
[[nodiscard]] std::vector<VerdictCount> count_verdicts(
    const std::vector<LoopCandidate>& candidates);

/// The number of candidates that were found in one way and rejected for one reason (without its
/// figures).
struct ReasonCount {
  std::string found_by;
  std::string reason;
  std::size_t count = 0;
};

/// Counts the reasons of each way of finding, the most frequent first.
[[nodiscard]] std::vector<ReasonCount> count_reasons(const std::vector<LoopCandidate>& candidates);

}  // namespace cvo_slam
