// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "cvo_slam/core/point_cloud.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/frontend/neighbor_grid_internal.h"
#include "cvo_slam/frontend/pair_table_internal.h"
#include "cvo_slam/frontend/registration.h"

namespace cvo_slam {

/// Lists the grid's points within its radius of each of the moving points [begin, end), moved by
/// T_fixed_moving.
void find_neighbors(const NeighborGrid& grid, const PointCloud& moving, const SE3& T_fixed_moving,
                    const KernelOptions& kernel, double length_scale, std::size_t begin,
                    std::size_t end, NeighborLists& lists);

/// Returns sum_ij c k over the moving points [begin, end), at the identity, and the grid's points;
/// all kernels are balls.
double sum_inner_products(const NeighborGrid& grid, const PointCloud& moving,
                          const KernelOptions& kernel, double length_scale, std::size_t begin,
                          std::size_t end);

}  // namespace cvo_slam
