// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/evaluation_plots.h"

#include <gtest/gtest.h>

#include "cvo_slam/tests/core/trajectory_samples.h"
#include "cvo_slam/tests/temporary_folder.h"

namespace cvo_slam {
namespace {

TEST(EvaluationPlots, AnEstimateOfAnotherClockIsDrawnOverTheSamePartOfTheReference) {
  const TemporaryFolder folder;
  const auto reference = helix(40);
  const std::vector<StampedPose> estimate(reference.begin() + 10, reference.begin() + 30);
  auto delayed = estimate;
  for (auto& pose : delayed) pose.stamp = Timestamp(pose.stamp.nanoseconds() + 100'000'000'000);

  write_figures(folder.path() / "same",
                evaluation_figures(estimate, estimate, evaluate(estimate, estimate)));
  const auto report = evaluate(reference, delayed, {.association = {.time_offset = -100}});
  write_figures(folder.path() / "other", evaluation_figures(reference, delayed, report));
  EXPECT_EQ(read_text(folder.path() / "other" / "trajectory.svg"),
            read_text(folder.path() / "same" / "trajectory.svg"));
}

}  // namespace
}  // namespace cvo_slam
