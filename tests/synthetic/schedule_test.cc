// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "cvo_slam/synthetic/schedule_internal.h"

namespace cvo_slam::synthetic {
namespace {

constexpr std::size_t kFrames = 4000;

TEST(Schedule, AnIdealSensorTakesBothImagesThirtyTimesASecond) {
  const auto frames = schedule(kFrames, {}, 1);
  ASSERT_EQ(frames.size(), kFrames);
  EXPECT_EQ(frames[0].color.to_string(), "1000.000000");
  EXPECT_EQ(frames[1].color.to_string(), "1000.033333");
  EXPECT_EQ(frames[300].color.to_string(), "1010.000000");
  EXPECT_DOUBLE_EQ(world_seconds(frames[300].color), 10);
  for (const auto& frame : frames) {
    ASSERT_EQ(frame.color, frame.depth);
    ASSERT_TRUE(frame.has_color && frame.has_depth);
  }
}

TEST(Schedule, DepthStampsDeviateAsAskedAndStayWithTheirFrame) {
  SensorOptions options;
  options.timing.depth_jitter = 0.011;
  const auto frames = schedule(kFrames, options, 1);
  double sum = 0;
  double squares = 0;
  for (std::size_t i = 0; i < kFrames; ++i) {
    const double delay = seconds_between(frames[i].color, frames[i].depth);
    sum += delay;
    squares += delay * delay;
    // Nearer to its own colour image than to the next one's, half of 33 ms away.
    ASSERT_LT(std::abs(delay), 0.0166);
    if (i > 0) {
      ASSERT_LT(frames[i - 1].depth, frames[i].depth);
    }
  }
  EXPECT_GE(frames[0].depth, frames[0].color);
  // 4,000 values: 1 % of statistical error.
  EXPECT_NEAR(std::sqrt(squares / kFrames), 0.011, 0.0003);
  EXPECT_NEAR(sum / kFrames, 0, 0.0006);
}

TEST(Schedule, DepthIsTakenAtTheOffsetAfterItsStamp) {
  SensorOptions options;
  options.timing.depth_jitter = 0.011;
  const auto plain = schedule(5, options, 1);
  options.timing.depth_offset = -0.019;
  const auto late_stamps = schedule(5, options, 1);
  for (std::size_t i = 0; i < plain.size(); ++i) {
    EXPECT_EQ(late_stamps[i].depth, plain[i].depth);
    EXPECT_NEAR(*late_stamps[i].exposure().depth, *plain[i].exposure().depth - 0.019, 1e-9);
    EXPECT_EQ(late_stamps[i].exposure().color, plain[i].exposure().color);
  }
}

TEST(Schedule, FrameRateIsThatOfTheOptions) {
  SensorOptions options;
  options.timing.frame_rate = 90;
  EXPECT_EQ(schedule(91, options, 1)[90].color.to_string(), "1001.000000");
}

TEST(Schedule, DropsTheSharesAskedFor) {
  SensorOptions options;
  options.timing.drop_color = 0.1;
  options.timing.drop_depth = 0.2;
  options.timing.drop_both = 0.3;
  double color = 0;
  double depth = 0;
  double both = 0;
  for (const auto& frame : schedule(kFrames, options, 1)) {
    color += frame.has_color ? 0 : 1.0 / kFrames;
    depth += frame.has_depth ? 0 : 1.0 / kFrames;
    both += frame.has_color || frame.has_depth ? 0 : 1.0 / kFrames;
  }
  // 4,000 values: 0.008 of statistical error.
  EXPECT_NEAR(color, 1 - 0.7 * 0.9, 0.03);
  EXPECT_NEAR(depth, 1 - 0.7 * 0.8, 0.03);
  EXPECT_NEAR(both, 1 - 0.7 * (1 - 0.1 * 0.2), 0.03);
}

TEST(Schedule, TheFirstFrameIsNeverDropped) {
  SensorOptions options;
  options.timing.drop_both = options.timing.drop_color = options.timing.drop_depth = 0.9;
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const auto frames = schedule(1, options, seed);
    EXPECT_TRUE(frames[0].has_color && frames[0].has_depth);
  }
}

TEST(Schedule, FollowsFromTheSeedsAndNotFromTheNumberOfFrames) {
  SensorOptions options = sensor_preset("harsh");
  const auto delays = [&](std::size_t frames, std::uint32_t seed) {
    std::vector<Timestamp> stamps;
    for (const auto& frame : schedule(frames, options, seed)) stamps.push_back(frame.depth);
    stamps.resize(10);
    return stamps;
  };
  const auto some = delays(10, 1);
  EXPECT_EQ(delays(20, 1), some);
  EXPECT_NE(delays(10, 2), some);
  options.seed = 1;
  EXPECT_NE(delays(10, 1), some);
}

TEST(Schedule, ReferenceStampsAreThoseOfTheImagesAndAHundredASecond) {
  SensorOptions options;
  options.timing.drop_color = 0.5;
  const auto frames = schedule(31, options, 1);
  const auto stamps = reference_stamps(frames);
  EXPECT_TRUE(std::is_sorted(stamps.begin(), stamps.end()));
  EXPECT_EQ(std::adjacent_find(stamps.begin(), stamps.end()), stamps.end());
  const auto has = [&](const Timestamp& stamp) {
    return std::binary_search(stamps.begin(), stamps.end(), stamp);
  };
  for (std::int64_t i = 0; i <= 100; ++i)
    EXPECT_TRUE(has(Timestamp(1000'000000000 + i * 10000000)));
  for (const auto& frame : frames) {
    // Every third frame is on a hundredth of a second, whether it was dropped or not.
    const bool on_grid = frame.color.nanoseconds() % 10000000 == 0;
    EXPECT_EQ(has(frame.color), frame.has_color || on_grid);
  }
}

}  // namespace
}  // namespace cvo_slam::synthetic
