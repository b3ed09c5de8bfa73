// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cvo_slam/backend/optimizer.h"

namespace cvo_slam {

/// What the optimisation of a growing graph came to.
struct GraphStatistics {
  int window_solves = 0;
  int full_solves = 0;
  double window_seconds = 0;  ///< wall time of all of them
  double full_seconds = 0;
  Summary last_full;  ///< the last optimisation of the whole graph
};

}  // namespace cvo_slam
