// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/sequence_run.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <ctime>
#include <set>

#include <fmt/format.h>
#include <sys/resource.h>

#include "cvo_slam/apps/progress.h"
#include "cvo_slam/core/error.h"
#include "cvo_slam/io/camera_check.h"
#include "cvo_slam/io/dataset.h"

namespace cvo_slam {
namespace {

volatile std::sig_atomic_t signal_received = 0;

void receive(int signal) {
  signal_received = signal;
  std::signal(signal, SIG_DFL);
}

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

double peak_memory_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;  // Linux counts kibibytes
}

/// What goes through the frames.
struct FrameConsumer {
  std::function<FrameRecord(const RgbdFrame&)> track;
  std::function<void()> finish;                          // after the last frame
  std::function<void(std::vector<SampledFrame>&)> thin;  // drops what the map does without
};

OdometryRun run_frames(const FrameStream& stream, const FrameConsumer& consumer,
                       const RunControl& control) {
  Progress progress(stream.count, control.quiet);
  OdometryRun run;
  const auto start = Clock::now();
  const double cpu_start = process_cpu_seconds();
  constexpr std::size_t kFirstFrames = 10;  // of which one at least has images, or none ever has
  std::size_t problems = 0;
  constexpr std::size_t kKeptBeforeThinning = 500;  // 85 MB of a Kinect's
  std::size_t most_kept = kKeptBeforeThinning;
  while (!InterruptGuard::requested() &&
         !(problems == kFirstFrames && problems == run.records.size())) {
    const auto wait_start = Clock::now();
    const std::optional<RgbdFrame> next = stream.frames.next();
    if (!next) break;
    const RgbdFrame& frame = *next;
    problems += frame.problem.empty() ? 0 : 1;
    const auto track_start = Clock::now();
    run.costs.push_back(
        {std::chrono::duration<double, std::milli>(track_start - wait_start).count(), 0});
    run.records.push_back(consumer.track(frame));
    run.costs.back().track_ms = milliseconds_since(track_start);
    if (control.kept_pixel_step > 0 && !run.records.back().keyframe_reason.empty()) {
      run.kept_keyframes.push_back(sample_frame(frame, control.kept_pixel_step));
    }
    if (run.kept_keyframes.size() >= most_kept) {
      consumer.thin(run.kept_keyframes);
      most_kept = std::max(kKeptBeforeThinning, 2 * run.kept_keyframes.size());
    }
    progress.update(run.records.size(),
                    run.records.back().status == TrackingStatus::kTracked ? "tracked" : "lost");
  }
  consumer.finish();
  run.unusable = problems > 0 && problems == run.records.size();
  run.seconds = milliseconds_since(start) / 1e3;
  run.cpu_seconds = process_cpu_seconds() - cpu_start;
  run.signal = InterruptGuard::signal();
  run.peak_memory_mb = peak_memory_mb();
  return run;
}

/// Drops the keyframes that the map has removed since; it does not have the newest ones yet.
void drop_removed(const std::vector<Keyframe>& in_map, std::vector<SampledFrame>& kept) {
  if (in_map.empty()) return;
  std::set<Timestamp> stamps;
  for (const Keyframe& keyframe : in_map) stamps.insert(keyframe.stamp);
  std::erase_if(kept, [&](const SampledFrame& frame) {
    return frame.stamp < in_map.back().stamp && !stamps.contains(frame.stamp);
  });
}

}  // namespace

InterruptGuard::InterruptGuard() {
  signal_received = 0;
  previous_interrupt_ = std::signal(SIGINT, receive);
  previous_termination_ = std::signal(SIGTERM, receive);
}

InterruptGuard::~InterruptGuard() {
  std::signal(SIGINT, previous_interrupt_);
  std::signal(SIGTERM, previous_termination_);
}

int InterruptGuard::signal() { return signal_received; }

double process_cpu_seconds() {
  return static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC);
}

std::size_t OdometryRun::keyframes() const {
  return static_cast<std::size_t>(
      std::count_if(records.begin(), records.end(),
                    [](const FrameRecord& record) { return !record.keyframe_reason.empty(); }));
}

double OdometryRun::fps() const {
  return seconds > 0 ? static_cast<double>(records.size()) / seconds : 0;
}

OdometryRun run_odometry(const FrameStream& stream, const TrackerOptions& options,
                         const RunControl& control) {
  Tracker tracker(stream.camera, options);
  return run_frames(stream,
                    {.track = [&](const RgbdFrame& frame) { return tracker.track(frame).record; },
                     .finish = [] {},
                     .thin = [](std::vector<SampledFrame>&) {}},
                    control);
}

std::optional<std::string> agreement_warning(const Dataset& data, const Trajectory& trajectory) {
  const bool has_reference = data.reference().size() > 1;
  const auto agreement =
      measure_reprojection(data, has_reference ? data.reference() : trajectory.poses);
  if (!agreement) return std::nullopt;
  const auto warning =
      reprojection_warning(*agreement, has_reference ? "the ground truth" : "the estimate");
  if (!warning) return std::nullopt;
  return "warning: " + *warning;
}

std::optional<EvaluationReport> evaluate_run(const Dataset& data, const Trajectory& trajectory,
                                             std::vector<std::string>& notes) {
  if (data.reference().empty()) {
    notes.emplace_back("no errors: the sequence has no ground truth");
    return std::nullopt;
  }
  try {
    return evaluate(data.reference(), trajectory.poses);
  } catch (const DataError& error) {
    notes.push_back(fmt::format("no errors: {}", error.what()));
    return std::nullopt;
  }
}

std::size_t LoadedMap::first_number() const {
  std::size_t number = 0;
  for (const KeyframeMemory& keyframe : map.memory->keyframes) {
    number = std::max(number, keyframe.number + 1);
  }
  return number;
}

SlamRun run_slam(const FrameStream& stream, const ProgramOptions& options,
                 const std::shared_ptr<const Vocabulary>& vocabulary, const RunControl& control,
                 const std::optional<LoadedMap>& loaded) {
  Slam slam = loaded ? Slam(loaded->map, options.slam, loaded->use, vocabulary)
                     : Slam(stream.camera, options.slam, vocabulary);
  SlamRun result;
  result.run = run_frames(stream,
                          {.track = [&](const RgbdFrame& frame) { return slam.track(frame); },
                           .finish = [&] { slam.finish(); },
                           .thin =
                               [&](std::vector<SampledFrame>& kept) {
                                 const bool is_located_only =
                                     loaded && loaded->use == MapUse::kLocalize;
                                 if (!is_located_only) drop_removed(slam.keyframes(), kept);
                               }},
                          control);
  result.trajectory = slam.trajectory(TrajectoryView::kFinal);
  result.graph = {slam.pose_graph(), slam.keyframes(), slam.loop_candidates(), slam.statistics(),
                  loaded ? loaded->first_number() : 0};
  if (control.keep_map) result.map = slam.map();
  return result;
}

}  // namespace cvo_slam
