// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cvo_slam/core/options.h"

namespace cvo_slam {

/// How much the squared error s = r^T information r of an edge that is flagged robust may cost.
enum class RobustLoss {
  kNone,    ///< s: as for every other edge
  kHuber,   ///< s up to c^2, then 2 c sqrt(s) - c^2
  kCauchy,  ///< c^2 log(1 + s / c^2)
  /// min(s, c^2), reached by graduated non-convexity: an edge is believed or it is not.
  /// H. Yang et al., "Graduated Non-Convexity for Robust Spatial Perception", RA-L 2020.
  kGnc,
};

enum class LinearSolver {
  kSuiteSparse,  ///< CHOLMOD, supernodal where that is faster; calls BLAS
  kEigen,  ///< Eigen's simplicial LDLT; calls no BLAS, so that none can change the last digits
};

/// Where the search starts.
enum class Initialization {
  kAuto,     ///< at the poses of the graph or at the chordal ones, whichever cost less
  kGiven,    ///< at the poses of the graph
  kChordal,  ///< at chordal_initialization()
};

struct OptimizerOptions {
  RobustLoss loss = RobustLoss::kNone;
  double loss_scale = 4.1;
  double gnc_factor = 1.4;
  Initialization initialization = Initialization::kAuto;
  LinearSolver solver = LinearSolver::kSuiteSparse;
  int max_iterations = 100;
  double cost_tolerance = 1e-7;
  int window = 20;
  int threads = 1;
};

[[nodiscard]] OptionSet describe(OptimizerOptions& options);

}  // namespace cvo_slam
