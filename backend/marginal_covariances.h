// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "cvo_slam/core/pose_graph.h"

namespace cvo_slam {

/// How certain the poses of an optimised graph are: the inverse of the Gauss-Newton Hessian at the
/// graph's poses, of which only the blocks that are asked for are computed. The matrix is
/// factorised once; a question costs six or twelve back-substitutions.
class MarginalCovariances {
 public:
  /// `weights` of the edges (Summary::weights), or none for 1. Throws DataError where the edges do
  /// not determine every node, as where information matrices are singular.
  explicit MarginalCovariances(const PoseGraph& graph, const std::vector<double>& weights = {});
  ~MarginalCovariances();
  MarginalCovariances(MarginalCovariances&& other) noexcept;
  MarginalCovariances& operator=(MarginalCovariances&& other) noexcept;

  /// Covariance of a right perturbation T_world_node exp(xi), xi = [translation; rotation]
  /// [m^2, m rad, rad^2], given the held nodes, whose own is zero. Throws DataError for an unknown
  /// node.
  [[nodiscard]] Matrix6 of(NodeId node) const;

  /// Covariance of a right perturbation of T_a_b = T_world_a^-1 T_world_b. This, plus that of a
  /// measurement, is what the measurement may differ by from the graph.
  [[nodiscard]] Matrix6 between(NodeId a, NodeId b) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace cvo_slam
