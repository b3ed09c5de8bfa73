// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "cvo_slam/synthetic/random_internal.h"
#include "cvo_slam/synthetic/schedule_internal.h"

namespace cvo_slam::synthetic {
namespace {

// The first stamp is not zero, so that all stamps have as many digits and file names sort by time.
constexpr std::int64_t kFirstSecond = 1000;
constexpr std::int64_t kMicroseconds = 1000000;  // in a second

enum SchedulePurpose : std::int32_t { kJitter = 101, kDropColor, kDropDepth, kDropBoth };

/// Returns a stamp of whole microseconds, as in file names, so that the pose is exact for the
/// stamp.
Timestamp stamp_after(std::int64_t microseconds) {
  return Timestamp((kFirstSecond * kMicroseconds + microseconds) * 1000);
}

/// Returns the delay of a depth image [us]: the sine of a uniformly distributed angle. It is
/// bounded, so that no depth image is nearer to another frame than to its own, and most values are
/// near the bounds, as in measured data (fr1/rpy).
std::int64_t depth_delay(double sigma, std::uint32_t seed, std::int32_t frame) {
  const double angle = 2 * std::numbers::pi * hash_unit(derived_seed(seed, kJitter), frame);
  const auto delay = std::llround(std::numbers::sqrt2 * sigma * std::sin(angle) *
                                  static_cast<double>(kMicroseconds));
  return frame == 0 ? std::llabs(delay) : delay;  // no image is before the first frame
}

}  // namespace

double world_seconds(const Timestamp& stamp) {
  const std::int64_t elapsed = stamp.nanoseconds() / 1000 - kFirstSecond * kMicroseconds;
  return static_cast<double>(elapsed) * 1e-6;
}

Exposure FrameTimes::exposure() const {
  Exposure exposure;
  if (has_color) exposure.color = world_seconds(color);
  if (has_depth) exposure.depth = world_seconds(depth) + depth_offset;
  return exposure;
}

std::vector<FrameTimes> schedule(std::size_t frames, const SensorOptions& options,
                                 std::uint32_t world_seed) {
  const TimingOptions& timing = options.timing;
  const std::uint32_t seed = sensor_seed(options.seed, world_seed);
  std::vector<FrameTimes> times;
  for (std::int32_t i = 0; static_cast<std::size_t>(i) < frames; ++i) {
    const auto kept = [&](double share, SchedulePurpose purpose) {
      return i == 0 || hash_unit(derived_seed(seed, purpose), i) >= share;
    };
    const std::int64_t elapsed = std::llround(i * (kMicroseconds / timing.frame_rate));
    const bool any = kept(timing.drop_both, kDropBoth);
    times.push_back({stamp_after(elapsed),
                     stamp_after(elapsed + depth_delay(timing.depth_jitter, seed, i)),
                     timing.depth_offset, any && kept(timing.drop_color, kDropColor),
                     any && kept(timing.drop_depth, kDropDepth)});
  }
  return times;
}

std::vector<Timestamp> reference_stamps(const std::vector<FrameTimes>& frames) {
  constexpr std::int64_t kPeriod = kMicroseconds / 100;
  const Timestamp end = frames.empty() ? stamp_after(-1) : frames.back().color;
  std::vector<Timestamp> stamps;
  for (std::int64_t t = 0; stamp_after(t) <= end; t += kPeriod) stamps.push_back(stamp_after(t));
  for (const auto& frame : frames) {
    if (frame.has_color) stamps.push_back(frame.color);
  }
  std::sort(stamps.begin(), stamps.end());
  stamps.erase(std::unique(stamps.begin(), stamps.end()), stamps.end());
  return stamps;
}

}  // namespace cvo_slam::synthetic
