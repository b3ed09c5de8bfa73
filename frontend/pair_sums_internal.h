// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "cvo_slam/core/point_cloud.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/frontend/neighbor_grid_internal.h"
#include "cvo_slam/frontend/pair_table_internal.h"
#include "cvo_slam/frontend/registration.h"

namespace cvo_slam {

/// Sums over the pairs of a table that are inside the kernel's support, with moved points
/// q_j = T z_j, r = x_i - q_j, w = c k, p = P_j r (kernel_precision()), s_j = sum_i w p / ell^2 and
/// A_j = sum_i (w / ell^2 P - w / ell^4 p p^T): all that the objective's derivatives need. k =
/// sigma^2 exp(-r^T p / (2 ell^2)).
struct PairSums {
  double value = 0;    ///< sum c (k - sparsification)
  double w = 0;        ///< sum w
  double matched = 0;  ///< moving points with a neighbour inside the support
  std::array<double, 3> s{};
  std::array<double, 3> q_cross_s{};
  std::array<double, 6> A{};    ///< xx, xy, xz, yy, yz, zz
  std::array<double, 9> AQ{};   ///< A q^, by columns
  std::array<double, 6> QAQ{};  ///< -q^ A q^: xx, xy, xz, yy, yz, zz
  std::array<double, 9> sq{};   ///< s q^T, by columns
  std::array<double, 6> B{};    ///< w P / ell^2: xx, xy, xz, yy, yz, zz
  std::array<double, 9> BQ{};   ///< B q^, by columns
  std::array<double, 6> QBQ{};  ///< -q^ B q^: xx, xy, xz, yy, yz, zz
};

/// Sums the groups [begin, end) of a table at a pose, in single precision within a moving point and
/// in double precision across points. The instruction set is chosen at run time; the order of the
/// sums depends on its vector width alone.
PairSums sum_pairs(const PairTable& table, const SE3& T_fixed_moving, const KernelOptions& kernel,
                   double length_scale, std::size_t begin, std::size_t end);

/// Returns the coefficients of t, t^2, t^3, t^4 of G(t) = F(h exp(t xi)) - F(h), for h = T^-1 and
/// the flow u = omega x q + v of the moved points q. With
/// ln k(t) = ln k(0) + beta t + gamma t^2 + delta t^3 + eps t^4 along the flow,
///   beta  = -1/ell^2 <u, r>,                  gamma = -1/(2 ell^2) (|u|^2 - <w^ u, r>),
///   delta = -1/(6 ell^2) <w^2 u, r>,          eps = 1/(24 ell^2) (|w^ u|^2 + <w^3 u, r>)
/// each pair adds w times the coefficients of the exponential series. (The paper's lack the
/// factorials and alternating signs.)
std::array<double, 4> sum_expansion(const PairTable& table, const SE3& T_fixed_moving,
                                    const KernelOptions& kernel, double length_scale,
                                    const Vector3& omega, const Vector3& v);

/// Return Highway's bits of the instruction sets that these functions are compiled for, and of the
/// one in use.
std::int64_t compiled_simd_targets();
std::int64_t simd_target_in_use();

/// Returns exp(x) for each x <= 0 as the sums compute it, so that tests can measure its error.
std::vector<float> simd_exp(std::span<const float> x);

}  // namespace cvo_slam
