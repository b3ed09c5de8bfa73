// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "cvo_slam/loop/pair_model_internal.h"
#include "cvo_slam/loop/random_internal.h"

namespace cvo_slam {

/// The pairs that a pose explains, in their order.
[[nodiscard]] std::vector<PointPair> inliers_of(const SE3& T_a_b, std::span<const PointPair> pairs,
                                                const PairModel& model);

/// The pose that explains most of the pairs, some of which are wrong: RANSAC over triples (M.
/// Fischler and R. Bolles, 1981) with truncated errors (MSAC, P. Torr and A. Zisserman, 2000),
/// where each pose that is the best so far is refined on its inliers (LO-RANSAC, O. Chum et al.,
/// 2003). A triple with depths on both sides gives a pose by aligning two triangles, one with
/// depths on one side by the perspective of three points. Ends after `iterations`, or earlier when
/// a better pose would have been found. Empty where no triple gives a pose.
[[nodiscard]] std::optional<SE3> search_pose(std::span<const PointPair> pairs,
                                             const PairModel& model, int iterations, Random random);

}  // namespace cvo_slam
