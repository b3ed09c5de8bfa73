// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "cvo_slam/core/trajectory_errors.h"
#include "cvo_slam/tests/core/trajectory_samples.h"

namespace cvo_slam {
namespace {

TEST(TimeOffset, OfTheEstimatesClockIsMeasured) {
  const auto reference = swaying(20);
  for (const int ms : {-210, -37, 0, 19, 333}) {
    SCOPED_TRACE(ms);
    const auto offset = measure_time_offset(reference, by_late_clock(swaying(16, 2000), ms));
    ASSERT_TRUE(offset);
    // The reference is interpolated between poses 20 ms apart, and the search ends at 0.1 ms.
    EXPECT_NEAR(*offset, -1e-3 * ms, 3e-4);
  }
}

TEST(TimeOffset, IsNoneIfItLiesBeyondHalfASecond) {
  EXPECT_FALSE(measure_time_offset(swaying(20), by_late_clock(swaying(16, 2000), 700)));
}

TEST(TimeOffset, IsNoneForACameraThatDoesNotTurnOrIsTooShort) {
  EXPECT_FALSE(measure_time_offset(line(100), line(100)));
  EXPECT_FALSE(measure_time_offset(swaying(20), {swaying(20).front()}));
}

TEST(TimeOffset, ABadOptionIsAnError) {
  EXPECT_THROW((void)measure_time_offset(swaying(5), swaying(5), {.max_gap = -1}), std::exception);
}

}  // namespace
}  // namespace cvo_slam
