// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "cvo_slam/frontend/newton_internal.h"
#include "cvo_slam/frontend/registration.h"

namespace cvo_slam {

/// A fixed point x inside the kernel's support of a moved point z~ = T z.
struct Pair {
  Vector3 d;  ///< x - z~
  double w;   ///< c k
};

/// All pairs, grouped by moved point.
struct PairList {
  struct Group {
    Vector3 z;  ///< z~
    std::size_t begin;
    std::size_t end;
  };
  std::vector<Group> groups;
  std::vector<Pair> pairs;

  [[nodiscard]] std::span<const Pair> of(const Group& group) const {
    return std::span(pairs).subspan(group.begin, group.end - group.begin);
  }
};

/// Fills `list` with the pairs of every moving point; reuses its memory.
void find_pairs(const NeighborGrid& grid, const PointCloud& moving, const SE3& T_fixed_moving,
                const KernelOptions& kernel, double length_scale, PairList& list);

/// An element xi of se(3); it acts on a moved point as the velocity u = omega x z~ + v. With
/// T = h^-1, h <- h exp(t xi) is T <- exp(-t xi) T.
struct FlowDirection {
  Vector3 omega = Vector3::Zero();
  Vector3 v = Vector3::Zero();
};

/// The direction of steepest ascent of F(h exp(t xi)) in the metric with weights a^2, b^2:
/// omega = 1/(a^2 ell^2) sum w (x x z~),  v = 1/(b^2 ell^2) sum w (z~ - x).
/// (The paper prints the opposite sign for v, which descends.)
[[nodiscard]] FlowDirection flow_direction(const PairList& list, double length_scale, double a2,
                                           double b2);

/// G(t) = F(h exp(t xi)) - F(h) to fourth order: g[0] t + g[1] t^2 + g[2] t^3 + g[3] t^4.
[[nodiscard]] std::array<double, 4> step_expansion(const PairList& list,
                                                   const FlowDirection& direction,
                                                   double length_scale);

/// The smallest positive real root of G'(t) = g0 + 2 g1 t + 3 g2 t^2 + 4 g3 t^3; empty where there
/// is none.
[[nodiscard]] std::optional<double> smallest_positive_stationary_point(
    const std::array<double, 4>& g);

/// Follows the gradient flow at one length scale.
[[nodiscard]] LevelResult gradient_flow(const Objective& objective, const PointCloud& moving,
                                        const SE3& T_fixed_moving_init, int max_iterations,
                                        const RegistrationOptions& options,
                                        const Executor& executor);

}  // namespace cvo_slam
