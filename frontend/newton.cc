// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <optional>

#include <Eigen/Cholesky>

#include "cvo_slam/frontend/solvers_internal.h"

namespace cvo_slam {
namespace {

/// Returns the ascent step A^-1 g; empty if A is not positive definite.
std::optional<Vector6> solve(const Matrix6& A, const Vector6& g) {
  const Eigen::LLT<AlignedMatrix6> llt{AlignedMatrix6(A)};
  // Also with a finite Cholesky factor the matrix may be singular to rounding.
  constexpr double kMinReciprocalCondition = 1e-12;
  if (llt.info() != Eigen::Success || llt.rcond() < kMinReciprocalCondition) return std::nullopt;
  const Vector6 step = llt.solve(g);
  if (!step.allFinite()) return std::nullopt;
  return step;
}

/// Shortens a step to what the kernel can see: a translation of ell and a rotation of ell / 2
/// (which moves a point 2 m away by ell).
Vector6 clamp(const Vector6& step, double ell) {
  const double translation = step.head<3>().norm() / ell;
  const double rotation = step.tail<3>().norm() / (0.5 * ell);
  return step / std::max({1.0, translation, rotation});
}

class Search {
 public:
  Search(PoseObjective& objective, const StopRule& stop) : objective_(objective), stop_(stop) {}

  LevelResult run(const SE3& T_init) {
    LevelResult state{T_init, objective_.evaluate(T_init), 0, false};
    while (state.iterations < stop_.max_iterations && state.value.matched > 0 && !state.converged) {
      ++state.iterations;
      const auto newton = solve(state.value.hessian, state.value.gradient);
      if (newton && try_step(*newton, state)) continue;
      const auto majorized = solve(state.value.majorizer, state.value.gradient);
      // If not even the majorised step climbs, rounding decides: this is the maximum.
      if (!majorized || !try_step(*majorized, state)) state.converged = majorized.has_value();
      if (!majorized) break;
    }
    return state;
  }

 private:
  /// Takes the step if it raises the objective; returns false if not. A step below the tolerance
  /// ends the search.
  bool try_step(const Vector6& step, LevelResult& state) {
    const Vector6 clamped = clamp(step, objective_.length_scale());
    const SE3 T = SE3::exp(clamped) * state.T_fixed_moving;
    if (clamped.head<3>().norm() < stop_.translation && clamped.tail<3>().norm() < stop_.rotation) {
      if (stop_.take_last_step) state.T_fixed_moving = T;
      state.converged = true;
      return true;
    }
    const ObjectiveValue value = objective_.evaluate(T);
    if (value.value <= state.value.value) return false;
    state.T_fixed_moving = T;
    state.value = value;
    return true;
  }

  PoseObjective& objective_;
  const StopRule& stop_;
};

}  // namespace

LevelResult newton(PoseObjective& objective, const SE3& T_fixed_moving_init, const StopRule& stop) {
  return Search(objective, stop).run(T_fixed_moving_init);
}

}  // namespace cvo_slam
