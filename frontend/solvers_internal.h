// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

#include "cvo_slam/frontend/objective_internal.h"
#include "cvo_slam/frontend/registration.h"

namespace cvo_slam {

/// The end of a search at one length scale.
struct LevelResult {
  SE3 T_fixed_moving;
  ObjectiveValue value;  ///< at T_fixed_moving
  int iterations = 0;
  bool converged = false;
};

/// When a search by Newton steps ends.
struct StopRule {
  int max_iterations = 10;
  double translation = 1e-4;  ///< a step must be shorter than this [m]
  double rotation = 1e-4;     ///< and than this [rad]
  /// True to take that last step, whose end is then not evaluated. A search that a finer one
  /// follows needs no proof of its end.
  bool take_last_step = false;
};

/// Maximises the objective at its length scale from a start by Newton steps; every accepted step
/// raises ObjectiveValue::value.
[[nodiscard]] LevelResult newton(PoseObjective& objective, const SE3& T_fixed_moving_init,
                                 const StopRule& stop);

/// Follows the paper's gradient flow at one length scale.
[[nodiscard]] LevelResult gradient_flow(PoseObjective& objective, const SE3& T_fixed_moving_init,
                                        int max_iterations, const FlowConstants& constants);

/// Throws OptionError if a constant that must be positive and finite is not.
void check(const FlowConstants& constants);

/// An element xi of se(3); it acts on a moved point as the velocity u = omega x z~ + v. With
/// T = h^-1, h <- h exp(t xi) is T <- exp(-t xi) T.
struct FlowDirection {
  Vector3 omega = Vector3::Zero();
  Vector3 v = Vector3::Zero();
};

/// Returns the direction of steepest ascent of F(h exp(t xi)) in the metric with weights a^2, b^2:
/// omega = 1/(a^2 ell^2) sum w (x x z~),  v = 1/(b^2 ell^2) sum w (z~ - x).
/// (The paper prints the opposite sign for v, which descends.) With r = x - z~ these are the sums
/// of the gradient with respect to a left perturbation of T, negated: h is the inverse of T.
[[nodiscard]] FlowDirection flow_direction(const ObjectiveValue& value, double a2, double b2);

/// Returns G(t) = F(h exp(t xi)) - F(h) to fourth order, g[0] t + g[1] t^2 + g[2] t^3 + g[3] t^4;
/// see sum_expansion() for the formulas.
[[nodiscard]] std::array<double, 4> step_expansion(PoseObjective& objective,
                                                   const SE3& T_fixed_moving,
                                                   const FlowDirection& direction);

/// Returns the smallest positive real root of G'(t) = g0 + 2 g1 t + 3 g2 t^2 + 4 g3 t^3; empty if
/// there is none.
[[nodiscard]] std::optional<double> smallest_positive_stationary_point(
    const std::array<double, 4>& g);

}  // namespace cvo_slam
