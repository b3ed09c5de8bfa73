// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "cvo_slam/core/se3.h"

namespace cvo_slam {

/// What is wrong with a matrix that should be an information (inverse covariance) matrix, as the
/// end of a sentence, or an empty text: it must be finite, symmetric and positive semi-definite,
/// the last two up to rounding.
[[nodiscard]] std::string information_problem(const Matrix6& information);

/// S with S^T S = information, so that |S r|^2 = r^T information r. Upper triangular where the
/// matrix is positive definite. `information` must have no information_problem().
[[nodiscard]] Matrix6 square_root_of_information(const Matrix6& information);

/// The information of an edge's residual (pose_graph_cost.h), where `information` is that of a
/// right perturbation of its measurement, T_from_to exp(xi), which is what registration answers.
[[nodiscard]] Matrix6 edge_information(const SE3& T_from_to, const Matrix6& information);

}  // namespace cvo_slam
