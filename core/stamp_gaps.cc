// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/core/stamp_gaps.h"

#include <cmath>

#include "cvo_slam/core/statistics.h"

namespace cvo_slam {

double longest_usual_step(const std::vector<Timestamp>& stamps) {
  constexpr double kUsualSteps = 5;
  constexpr double kAlwaysJoined = 0.5;
  std::vector<double> steps;
  for (std::size_t i = 1; i < stamps.size(); ++i) {
    steps.push_back(seconds_between(stamps[i - 1], stamps[i]));
  }
  return std::fmax(kUsualSteps * summarize(steps).median, kAlwaysJoined);
}

}  // namespace cvo_slam
