// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "cvo_slam/core/point_cloud.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/frontend/kernel.h"
#include "cvo_slam/frontend/neighbor_grid_internal.h"

namespace cvo_slam {

/// What one moving point q contributes: sums over the fixed points x_i inside the kernel's support,
/// with w = c k and r = x_i - q. All that gradient and Hessian need of the pairs.
struct PairSums {
  float k = 0;       ///< sum k: positive where there is any neighbour
  float w = 0;       ///< sum w
  float excess = 0;  ///< sum c (k - sparsification)
  float r[3] = {};   ///< sum w r
  float rr[6] = {};  ///< sum w r r^T: xx, xy, xz, yy, yz, zz
};

/// Sums the pairs of moving points [begin, end), moved by T_fixed_moving, with the points of the
/// grid, at one length scale [m]; writes end - begin results. Single precision inside, SIMD chosen
/// at run time; the order of the sums depends on the SIMD width alone.
void sum_pairs(const NeighborGrid& grid, const PointCloud& moving, const SE3& T_fixed_moving,
               const KernelOptions& kernel, double length_scale, std::size_t begin, std::size_t end,
               PairSums* sums);

/// exp(x) for each x <= 0, as the sums compute it (for tests of its error).
std::vector<float> simd_exp(std::span<const float> x);

}  // namespace cvo_slam
