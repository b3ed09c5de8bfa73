// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include "cvo_slam/core/association.h"
#include "cvo_slam/core/pose_error.h"

namespace cvo_slam {

enum class DeltaUnit { kFrames, kMetres, kSeconds };

/// "frames", "m" or "s".
[[nodiscard]] std::string_view to_string(DeltaUnit unit);

/// Which distance of two relative motions is taken, Q of the reference and P of the estimate, both
/// T_i_j of the later pose j in the earlier i.
enum class RelativeErrorKind {
  /// Of E = Q^-1 P the length of the translation and the angle (Sturm et al., IROS 2012, Eq. (2)).
  kRelativePose,
  /// Of P Q^-1 the length of the translation |T1 - R1 R2^T T2| and |log(R1 R2^T)|_F, which is
  /// sqrt(2) times the angle (Ghaffari et al., RSS 2019, section VI).
  kCvoPaper,
};

struct RelativePoseOptions {
  double delta = 1;  ///< distance of the poses of a pair, > 0; a whole number of frames
  DeltaUnit unit = DeltaUnit::kSeconds;
  /// Whether a pair starts at every pose, or where the last pair ended.
  bool all_pairs = true;
  /// With all pairs over metres: largest share of delta by which a pair may miss it.
  double relative_tolerance = 0.1;
  /// Over seconds: by how much a pair may be longer than delta [s]. More means lost frames.
  double time_tolerance = 0.05;
  RelativeErrorKind kind = RelativeErrorKind::kRelativePose;
};

/// Frame to frame, the CVO paper's own measure.
[[nodiscard]] constexpr RelativePoseOptions cvo_paper_options() {
  return {.unit = DeltaUnit::kFrames, .all_pairs = false, .kind = RelativeErrorKind::kCvoPaper};
}

/// How far the motion over a distance delta is from the reference's (RPE): drift.
struct RelativePoseError {
  std::vector<PoseError> errors;  ///< one a pair, with the stamp of its later pose
  PoseErrorStatistics statistics;
};

/// Indices (i, j), i < j, of the matches that make pairs:
/// - frames: j = i + delta, counted in matches; not all pairs: i = 0, delta, 2 delta, ...
/// - metres: along the estimate's path. All pairs: j is where the path from i is nearest to delta,
///   if within the tolerance. Not all: the path is cut where at least delta has gathered since the
///   last cut; pairs are consecutive cuts (what lies before the first cut makes no pair, as in evo)
/// - seconds: j is the first with t_j >= t_i + delta, if within the tolerance. Not all: the next
///   pair starts at j, or at i + 1 where i has no partner
/// Throws OptionError for a delta or tolerance that is impossible.
[[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> select_pairs(
    const std::vector<MatchedPose>& matches, const RelativePoseOptions& options);

/// RPE of poses matched by associate(). Throws DataError where no two are delta apart, and
/// OptionError as select_pairs() does.
[[nodiscard]] RelativePoseError relative_pose_error(const std::vector<MatchedPose>& matches,
                                                    const RelativePoseOptions& options = {});

}  // namespace cvo_slam
