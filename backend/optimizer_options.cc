// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/backend/optimizer_options.h"

namespace cvo_slam {

OptionSet describe(OptimizerOptions& o) {
  return OptionSet()
      .add(
          "loss", o.loss,
          {{"none", RobustLoss::kNone},
           {"huber", RobustLoss::kHuber},
           {"cauchy", RobustLoss::kCauchy},
           {"gnc", RobustLoss::kGnc}},
          "Of edges that may be wrong altogether (flagged robust). gnc takes many solves and finds "
          "the wrong ones among many; huber and cauchy only weaken them.")
      .add("loss_scale", o.loss_scale, {1e-3, 1e6}, "",
           "c: errors above so many standard deviations are robustified. The default is the square "
           "root of chi-square's 99 % with six degrees of freedom, 16.8.")
      .add("gnc_factor", o.gnc_factor, {1.05, 100}, "",
           "gnc: by how much the surrogate of the loss becomes less convex between solves. The "
           "paper's value; 2 takes half the solves, and failed with 40 % of false loops on a graph "
           "where 1.4 did not.")
      .add("initialization", o.initialization,
           {{"auto", Initialization::kAuto},
            {"given", Initialization::kGiven},
            {"chordal", Initialization::kChordal}},
           "Where the search starts: auto takes the given or the chordal poses, whichever cost "
           "less; the chordal ones are less work than one iteration.")
      .add("solver", o.solver,
           {{"suitesparse", LinearSolver::kSuiteSparse}, {"eigen", LinearSolver::kEigen}},
           "Sparse Cholesky factorisation. suitesparse is the faster of the two on large graphs; "
           "eigen depends on no BLAS.")
      .add("max_iterations", o.max_iterations, {1, 100000}, "",
           "Most iterations of one solve. A graph that needs more than twenty is ill.")
      .add("cost_tolerance", o.cost_tolerance, {0, 1}, "",
           "A solve ends when an iteration lowers the cost by less than this share of it.")
      .add("window", o.window, {1, 1000000}, "",
           "Incremental use: nodes farther from the newest than so many edges are held, unless a "
           "full solve is asked for.")
      .add("threads", o.threads, {1, 1024}, "",
           "Threads that evaluate edges. Results do not depend on it; the factorisation, most of "
           "the time, has one.");
}

}  // namespace cvo_slam
