// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/slam/depth_offset.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cvo_slam/slam/clock_evidence_internal.h"

namespace cvo_slam {
namespace {

/// A value and its standard deviation.
struct Estimate {
  double value = 0;
  double deviation = 0;
};

double minimum(const ClockEvidence& sum) { return -sum.slope / sum.curvature; }

/// Returns the correction of the offset that pairs of frames ask for [s], and its standard
/// deviation by a jackknife over stretches of successive pairs, whose errors are not independent.
std::optional<Estimate> correction_of(const std::vector<ClockEvidence>& pairs) {
  constexpr std::size_t kStretches = 10;
  if (pairs.size() < 3 * kStretches) return std::nullopt;
  std::array<ClockEvidence, kStretches> stretches{};
  ClockEvidence all;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    for (ClockEvidence* sum : {&stretches[i * kStretches / pairs.size()], &all}) {
      sum->curvature += pairs[i].curvature;
      sum->slope += pairs[i].slope;
    }
  }
  if (!(all.curvature > 0)) return std::nullopt;
  double squares = 0;
  for (const ClockEvidence& stretch : stretches) {
    const double change =
        minimum({all.curvature - stretch.curvature, all.slope - stretch.slope}) - minimum(all);
    squares += change * change;
  }
  constexpr double kShare = (kStretches - 1.0) / kStretches;
  // Where the camera hardly moves, all stretches may agree by chance.
  const double least = 1 / std::sqrt(all.curvature);
  return Estimate{minimum(all), std::max(least, std::sqrt(kShare * squares))};
}

/// A frame and what the tracker found of it.
struct SeenFrame {
  RgbdFrame frame;
  FrameRecord record;

  [[nodiscard]] bool is_tracked() const { return record.status == TrackingStatus::kTracked; }
};

/// Returns the velocity between the frames around one, [m/s; rad/s]; nothing if one of the three is
/// lost. Unlike the tracker's own it does not lag behind.
std::optional<Vector6> velocity_of(const SeenFrame& before, const SeenFrame& frame,
                                   const SeenFrame& after) {
  const int submap = frame.record.submap;
  if (!before.is_tracked() || !frame.is_tracked() || !after.is_tracked() ||
      before.record.submap != submap || after.record.submap != submap) {
    return std::nullopt;
  }
  return (before.record.T_world_camera.inverse() * after.record.T_world_camera).log() /
         seconds_between(before.frame.stamp, after.frame.stamp);
}

/// A round: the beginning of the recording, paired with one offset. A tracker finds the poses;
/// pairs of frames a quarter of a second apart then tell how much the offset is off.
class Round {
 public:
  Round(const Camera& camera, const TrackerOptions& options)
      : camera_(camera), clock_camera_(camera), tracker_(camera, options) {}

  void track(const RgbdFrame& frame) {
    recent_.push_back({frame, tracker_.track(frame).record});
    if (recent_.size() < 3) return;
    if (const auto velocity = velocity_of(recent_[0], recent_[1], recent_[2])) {
      look_at(recent_[1], *velocity);
    } else {
      earlier_.clear();
    }
    recent_.pop_front();
  }

  [[nodiscard]] const std::vector<ClockEvidence>& pairs() const { return pairs_; }

 private:
  void look_at(const SeenFrame& seen, const Vector6& velocity) {
    constexpr std::size_t kEvery = 2;  // neighbouring frames say nearly the same
    constexpr std::size_t kBetween = 4;
    if (count_++ % kEvery != 0) return;
    ClockFrame frame = make_clock_frame(seen.frame);
    frame.T_world_camera = seen.record.T_world_camera;
    frame.velocity = velocity;
    frame.delay = seconds_between(seen.frame.stamp, seen.frame.depth_stamp) +
                  camera_.depth_offset.value_or(0);
    earlier_.push_back(std::move(frame));
    if (earlier_.size() <= kBetween) return;
    if (const auto pair = clock_evidence(earlier_.front(), earlier_.back(), clock_camera_)) {
      pairs_.push_back(*pair);
    }
    earlier_.pop_front();
  }

  Camera camera_;
  ClockCamera clock_camera_;
  Tracker tracker_;
  std::deque<SeenFrame> recent_;  // at most three
  std::deque<ClockFrame> earlier_;
  std::size_t count_ = 0;
  std::vector<ClockEvidence> pairs_;
};

/// Returns true if a correction is so large that a more exact value is not worth more frames: the
/// images are paired anew with it and measured again.
bool is_clearly_wrong(const Estimate& correction) {
  constexpr double kClearly = 4;    // standard deviations
  constexpr double kLarge = 0.003;  // [s]
  return std::fabs(correction.value) > std::max(kLarge, kClearly * correction.deviation);
}

/// Returns true if images need not be paired anew with the corrected offset.
bool is_settled(const Estimate& correction) {
  constexpr double kSettled = 0.001;  // [s]; a smaller correction changes hardly a pair
  return std::fabs(correction.value) <= std::max(kSettled, 0.5 * correction.deviation);
}

/// Tracks until the correction is known well enough or the frames are at an end.
std::optional<Estimate> measure(FrameSource& source, Round& round,
                                const DepthOffsetOptions& options, std::size_t& seen) {
  constexpr std::size_t kCheckEvery = 100;  // [frames]
  std::optional<Timestamp> first;
  for (seen = 0; seen < options.max_frames;) {
    const auto frame = source.next();
    if (!frame) break;
    round.track(*frame);
    if (!first) first = frame->stamp;
    if (++seen % kCheckEvery != 0) continue;
    const auto correction = correction_of(round.pairs());
    if (!correction) continue;
    const bool is_long = seconds_between(*first, frame->stamp) >= options.settled_time;
    const bool enough = seen >= options.min_frames && correction->deviation <= options.enough &&
                        (is_long || !is_settled(*correction));
    if (enough || is_clearly_wrong(*correction)) return correction;
  }
  return correction_of(round.pairs());
}

/// An offset and the correction that the images ask for that are paired with it.
struct RoundResult {
  double offset = 0;
  double correction = 0;
};

/// Returns the offset that the next round is paired with. Where images were paired badly, the
/// correction is too short; from the second round on it is made as much longer as the last one
/// should have been (the secant method).
double next_offset(double offset, double correction, std::optional<RoundResult>& previous) {
  constexpr double kLongest = 3;
  double factor = 1;
  if (previous && correction * previous->correction > 0) {
    const double done = previous->correction - correction;
    const double wanted = offset - previous->offset;
    if (done * wanted > 0) factor = std::clamp(wanted / done, 1.0, kLongest);
  }
  previous = RoundResult{offset, correction};
  return offset + factor * correction;
}

DepthOffset not_measured(std::size_t frames, double uncertainty, std::string reason) {
  return {false, 0, uncertainty, frames, std::move(reason)};
}

}  // namespace

DepthOffset calibrate_depth_offset(const FramesPairedWith& open, const Camera& camera,
                                   const TrackerOptions& tracker,
                                   const DepthOffsetOptions& options) {
  constexpr int kMostRounds = 8;
  constexpr int kPoints = 750;  // the poses are only where the comparison of frames starts
  TrackerOptions tracking = tracker;
  tracking.compensate_depth_delay = true;
  tracking.points = std::min(tracking.points, kPoints);
  tracking.keyframe_points = std::min(tracking.keyframe_points, 4 * kPoints);
  Camera paired = camera;
  std::optional<RoundResult> previous;
  double offset = options.start;
  for (int i = 0; i < kMostRounds; ++i) {
    paired.depth_offset = offset;
    Round round(paired, tracking);
    const auto source = open(offset);
    std::size_t seen = 0;
    const auto correction = measure(*source, round, options, seen);
    if (!correction) {
      return not_measured(seen, 0, "the recording does not tell: too few frames that are tracked");
    }
    offset = next_offset(offset, correction->value, previous);
    if (std::fabs(offset) > options.max_offset) {
      return not_measured(seen, 0,
                          fmt::format("it would be beyond {:.0f} ms", 1e3 * options.max_offset));
    }
    if (!(correction->deviation <= options.max_uncertainty)) {
      return not_measured(
          seen, correction->deviation,
          fmt::format("the recording does not tell: the camera moves too little (+-{:.1f} ms)",
                      1e3 * correction->deviation));
    }
    if (is_settled(*correction)) {
      return {true, offset, correction->deviation, seen,
              fmt::format("measured on {} frames, +-{:.1f} ms", seen, 1e3 * correction->deviation)};
    }
  }
  return not_measured(0, 0, "it did not settle");
}

}  // namespace cvo_slam
