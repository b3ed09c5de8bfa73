// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/frontend/registration.h"

namespace cvo_slam {

OptionSet describe(FlowOptions& o) {
  return OptionSet()
      .add("metric_a2", o.metric_a2, {1e-3, 1e6}, "",
           "Weight a^2 of rotations in the metric. The paper's value.")
      .add("metric_b2", o.metric_b2, {1e-3, 1e6}, "",
           "Weight b^2 of translations in the metric. The paper's value.")
      .add("max_step", o.max_step, {1e-6, 1e6}, "",
           "Longest step in time of the flow without 1/ell^2. The authors' value.")
      .add("fallback_step", o.fallback_step, {1e-6, 1e6}, "",
           "Step where the expansion has no stationary point. The authors' value.")
      .add("min_step", o.min_step, {0, 1}, "",
           "Stops when the step's distance |log|_F on SE(3) is below this. The paper's value.")
      .add(
          "min_gradient", o.min_gradient, {0, 1e6}, "",
          "Stops when both parts of the flow, without 1/ell^2, are below this. The paper's value.");
}

OptionSet describe(RegistrationOptions& o) {
  return OptionSet()
      .add("solver", o.solver, {{"flow", Solver::kFlow}, {"newton", Solver::kNewton}},
           "newton finds the same maximum as the paper's flow in a fraction of the iterations.")
      .add("kernel", describe(o.kernel))
      .add(
          "length_scales", o.length_scales, {1e-4, 10}, "m",
          "Length scales of the position kernel, run one after the other for every pair. The first "
          "reaches motions that the prediction misses by a decimetre; the last is a Kinect's depth "
          "noise at 3 m. Coarse scales alone are biased towards dense regions.")
      .add(
          "max_iterations", o.max_iterations, {1, 10000}, "",
          "Most iterations at each length scale; the last entry also holds for those after it. The "
          "coarse scales only prepare the next: a few steps will do.")
      .add("coarser_share", o.coarser_share, {0.05, 1}, "",
           "Every length scale uses this share of the points (of both clouds) that the next finer "
           "one uses; the last uses all. Twice as wide a kernel reaches four times the points of a "
           "surface, of which it needs no more than a fine one.")
      .add("coarse_tolerance", o.coarse_tolerance, {0, 10}, "",
           "A length scale before the last ends with a translation below this share of the next "
           "one: that is where the next one takes over.")
      .add("tolerance_translation", o.tolerance_translation, {0, 1}, "m",
           "newton: a step shorter than both tolerances ends a length scale. A hundredth of the "
           "finest scale.")
      .add("tolerance_rotation", o.tolerance_rotation, {0, 1}, "rad",
           "newton: a step shorter than both tolerances ends a length scale.")
      .add("depth_noise", o.depth_noise, {0, 1}, "1/m",
           "For the information matrix: the standard deviation of a depth z is this times z^2. "
           "More than twice a Kinect's 0.003 (axial noise and disparity steps), as its noise is "
           "correlated and both clouds have it.")
      .add("information_scale", o.information_scale, {1e-6, 1e6}, "",
           "Factor of the information matrix, calibrated with depth_noise on synthetic rooms with "
           "a Kinect's noise so that most errors are inside the 95 % gate; see "
           "docs/theory/tracking.md.")
      .add("flow", describe(o.flow));
}

void check_consistency(const RegistrationOptions& options) {
  const double peak = options.kernel.sigma * options.kernel.sigma;
  if (options.kernel.sparsification < peak) return;
  throw OptionError(
      fmt::format("kernel.sparsification={} leaves nothing of a kernel whose peak is sigma^2={}; "
                  "take a smaller one",
                  options.kernel.sparsification, peak));
}

}  // namespace cvo_slam
