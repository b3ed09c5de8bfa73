// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "cvo_slam/core/alignment.h"
#include "cvo_slam/core/association.h"
#include "cvo_slam/core/pose_error.h"

namespace cvo_slam {

/// How far an estimate is from the reference as a whole (ATE; evo calls it APE).
struct AbsoluteTrajectoryError {
  Similarity alignment;           ///< what was applied to the estimate
  std::vector<PoseError> errors;  ///< one a match, with its stamp
  PoseErrorStatistics statistics;
};

/// ATE of poses matched by associate(): with E = T_reference^-1 T_estimate after alignment, the
/// length of its translation and its angle. J. Sturm et al., "A Benchmark for the Evaluation of
/// RGB-D SLAM Systems", IROS 2012, Eq. (4), here with the rotation too.
/// Throws DataError where there is no match or the alignment is not unique.
[[nodiscard]] AbsoluteTrajectoryError absolute_trajectory_error(
    const std::vector<MatchedPose>& matches, Alignment alignment = Alignment::kSe3);

}  // namespace cvo_slam
