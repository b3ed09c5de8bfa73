// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "cvo_slam/synthetic/scene_builder_internal.h"

namespace cvo_slam::synthetic {

/// A straight wall within a house, on the floor from one point to another [m].
struct Partition {
  static constexpr double kThickness = 0.12;      ///< [m]
  static constexpr double kOpeningHeight = 2.05;  ///< [m]

  Vector3 from, to;
  double height;                 ///< [m]
  Texture left, right;           ///< of its sides, for someone who walks along it
  std::vector<double> openings;  ///< doorways without a door: their middles' distances from `from`
  double opening_width = 1.0;    ///< [m]
};

/// Builds the wall, and frames around its openings.
void partition(SceneBuilder& builder, const Partition& wall);

}  // namespace cvo_slam::synthetic
