// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cvo_slam/core/pose_graph.h"

namespace cvo_slam {

/// The residual of a measurement T_ab, the one that the back-end minimises:
///
///   r = [ R_a^T (p_b - p_a) - p_ab ; 2 vec(q_ab q_est^-1) ],   q_est = q_a^-1 q_b
///
/// [m; rad for small angles: 2 sin(angle / 2)], both parts seen in frame a. Products are
/// Hamilton's, and of the two quaternions of the rotation q_ab q_est^-1 the one with w >= 0 is
/// taken. This is the residual of Ceres' own pose-graph example, for which optima are published.
[[nodiscard]] Vector6 between_residual(const SE3& T_world_a, const SE3& T_world_b,
                                       const SE3& T_a_b);

/// r^T information r of one edge in edges().
[[nodiscard]] double squared_error(const PoseGraph& graph, std::size_t edge);

/// Half the sum of the edges' squared errors: the cost in Ceres' convention.
[[nodiscard]] double graph_cost(const PoseGraph& graph);

/// chi2 as the program g2o prints it: the sum (not its half) of e^T information e with
/// e = [p ; vec(q)] of the pose T_ab^-1 T_a^-1 T_b, w >= 0 (R. Kuemmerle et al., "g2o: A General
/// Framework for Graph Optimization", ICRA 2011). Half the angle where ours has the angle.
[[nodiscard]] double graph_chi2_g2o(const PoseGraph& graph);

}  // namespace cvo_slam
