// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cvo_slam/core/options.h"
#include "cvo_slam/core/pose_graph.h"

namespace cvo_slam {

/// The cost of a robust edge (PoseGraphEdge::robust) as a function of its squared error
/// s = r^T information r, with c = OptimizerOptions::loss_scale.
enum class RobustLoss {
  kNone,    ///< s, as for every other edge
  kHuber,   ///< s up to c^2, then 2 c sqrt(s) - c^2
  kCauchy,  ///< c^2 log(1 + s / c^2)
  /// min(s, c^2), reached by graduated non-convexity: an edge is accepted or rejected. H. Yang et
  /// al., "Graduated Non-Convexity for Robust Spatial Perception", RA-L 2020. What the edges
  /// connect stays connected: of rejected edges that would, the best ones are kept.
  kGnc,
};

/// What factorises the sparse matrix of each iteration (Cholesky).
enum class LinearSolver {
  kSuiteSparse,  ///< CHOLMOD, supernodal where that is faster; calls BLAS
  kEigen,        ///< Eigen's simplicial LDLT; calls no BLAS, so that its version cannot matter
};

/// The poses at which the search starts.
enum class Initialization {
  kAuto,     ///< the poses of the graph or the chordal ones, whichever cost less
  kGiven,    ///< the poses of the graph
  kChordal,  ///< the poses of chordal_initialization()
};

/// How a pose graph is optimised.
struct OptimizerOptions {
  /// Loss of the edges that may be outliers (PoseGraphEdge::robust). kNone is right if every edge
  /// was verified, as the mapper does. Take kGnc for a graph with unverified loops: it takes many
  /// solves and finds the outliers even among 40 % of them. kHuber and kCauchy only weaken them.
  RobustLoss loss = RobustLoss::kNone;
  /// c, the error above which the loss takes effect [standard deviations], 1e-3 to 1e6. The default
  /// is the square root of chi-square's 99 % quantile with six degrees of freedom, 16.8. Raise it
  /// if the information matrices are too confident.
  double loss_scale = 4.1;
  /// Factor by which kGnc makes the loss less convex between two solves, 1.05 to 100. The default
  /// is the value of the paper.
  double gnc_factor = 1.4;
  Initialization initialization = Initialization::kAuto;  ///< where the search starts
  LinearSolver solver =
      LinearSolver::kSuiteSparse;  ///< how the matrix of an iteration is factorised
  /// Most iterations of one solve, 1 to 100000. A graph that needs more than twenty is
  /// ill-conditioned; lower it to bound the time of a solve.
  int max_iterations = 100;
  /// A solve ends when an iteration lowers the cost by less than this share of it, 0 to 1.
  double cost_tolerance = 1e-7;
  /// Incremental use: nodes farther than this many edges from the newest node are held, unless a
  /// full solve is asked for [edges], 1 to 1000000. Larger windows spread corrections farther and
  /// take more time per keyframe.
  int window = 20;
};

/// Returns the options with their keys, ranges and documentation.
[[nodiscard]] OptionSet describe(OptimizerOptions& options);

/// The result of an optimisation. Costs are half the sum of the edges' squared errors, with the
/// loss applied to robust edges: what is minimised, in Ceres' convention (graph_cost()).
struct Summary {
  double initial_cost = 0;  ///< at the poses that were given
  double final_cost = 0;    ///< at the poses that were found
  int iterations = 0;       ///< of Ceres, over all solves except the rough ones of RobustLoss::kGnc
  int solves = 0;           ///< more than one if RobustLoss::kGnc changed a decision at the end
  bool converged = false;   ///< false if the last solve reached the limit of iterations or failed
  std::string reason;       ///< why the search ended, in words
  bool started_chordal = false;  ///< true if the search started at the chordal poses
  std::vector<double> weights;   ///< of each edge, in [0, 1]; below 0.5 the edge is rejected
  double seconds = 0;            ///< wall time
  /// What a robust loss did that needs a look, a line each: edges that RobustLoss::kGnc kept
  /// although they are wrong, because a part of the graph would have come loose without them, and
  /// the rejection of everything that closes a loop.
  std::vector<std::string> notes;

  /// Returns the number of edges with a weight below 0.5.
  [[nodiscard]] std::size_t rejected_edges() const;
};

/// Moves the nodes of the graph to the least-squares optimum; held nodes (PoseGraph::held_nodes())
/// stay. A graph in which nothing can be moved is left unchanged, and has converged. Throws
/// OptionError if an option is out of range.
Summary optimize(PoseGraph& graph, const OptimizerOptions& options = {});

/// Returns poses near the optimum from the measurements alone: L. Carlone et al., "Initialization
/// Techniques for 3D SLAM", ICRA 2015, Sec. III-B. The rotations are solved first as if any 3x3
/// matrix were a rotation, which is sparse linear least squares, and are rounded to the nearest
/// rotations; the positions follow from another linear problem. Only the mean weights of the
/// translation and of the rotation of an edge's information are used. Held nodes keep their poses;
/// the poses of all other nodes do not matter. Returns nothing if the weights of the edges are too
/// small to determine a node.
[[nodiscard]] std::optional<std::vector<SE3>> chordal_initialization(const PoseGraph& graph);

}  // namespace cvo_slam
