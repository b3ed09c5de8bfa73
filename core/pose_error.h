// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "cvo_slam/core/statistics.h"
#include "cvo_slam/core/timestamp.h"

namespace cvo_slam {

/// The error of one pose, or of one pair of poses.
struct PoseError {
  Timestamp stamp;
  double translation = 0;  ///< [m]
  double rotation = 0;     ///< [rad]
};

struct PoseErrorStatistics {
  Statistics translation;  ///< [m]
  Statistics rotation;     ///< [rad]
};

[[nodiscard]] PoseErrorStatistics summarize(const std::vector<PoseError>& errors);

}  // namespace cvo_slam
