// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cvo_slam/backend/optimizer.h"

namespace cvo_slam {

/// The weight of a measurement of squared error s under the truncated least-squares loss min(s,
/// c^2) made less convex as mu grows from 0 to infinity: H. Yang et al., "Graduated Non-Convexity
/// for Robust Spatial Perception", RA-L 2020, Eq. (14).
[[nodiscard]] double gnc_weight(double s, double c2, double mu);

/// Fits the graph again and again, weighting its robust edges, until each of them is believed or
/// not, then solves it with those that are; fills in the summary but for costs and time.
void graduate(PoseGraph& graph, const OptimizerOptions& options, Summary& summary);

}  // namespace cvo_slam
