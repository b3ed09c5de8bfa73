// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/odometry_benchmark.h"

#include <algorithm>
#include <ctime>
#include <functional>
#include <utility>

#include <fmt/format.h>

#include "cvo_slam/apps/opencv_odometry.h"
#include "cvo_slam/core/error.h"
#include "cvo_slam/core/options.h"
#include "cvo_slam/frontend/tracker.h"

namespace cvo_slam {
namespace {

using SystemPointer = std::unique_ptr<OdometrySystem>;

class TrackerSystem final : public OdometrySystem {
 public:
  TrackerSystem(const Camera& camera, const TrackerOptions& options) : tracker_(camera, options) {}

  std::optional<SE3> track(const RgbdFrame& frame) override {
    const FrameRecord& record = records_.emplace_back(tracker_.track(frame).record);
    if (record.status == TrackingStatus::kLost) return std::nullopt;
    return record.T_world_camera;
  }

  /// Frames of other submaps than the longest count as lost, as in `run`.
  std::optional<Trajectory> finish() override { return to_trajectory(records_); }

 private:
  Tracker tracker_;
  std::vector<FrameRecord> records_;
};

struct Entry {
  std::string name;
  std::string description;
  std::function<SystemPointer(const Camera&, const TrackerOptions&)> make;
};

Entry opencv_entry(const std::string& name, const std::string& type, OpencvMethod method) {
  return {name, "cv::rgbd::" + type + ", frame to frame, on undistorted images",
          [method](const Camera& camera, const TrackerOptions&) {
            return make_opencv_odometry(method, camera);
          }};
}

const std::vector<Entry>& entries() {
  static const std::vector<Entry> table = {
      {"ours", "cvo_slam::Tracker", make_tracker_system},
      {"paper", "cvo_slam::Tracker with the CVO paper's protocol, frame to frame",
       [](const Camera& camera, const TrackerOptions&) {
         return make_tracker_system(camera, paper_options());
       }},
      opencv_entry("rgbd", "RgbdOdometry", OpencvMethod::kRgbd),
      opencv_entry("rgbd_icp", "RgbdICPOdometry", OpencvMethod::kRgbdIcp),
      opencv_entry("icp", "ICPOdometry", OpencvMethod::kIcp),
  };
  return table;
}

const Entry& find_entry(const std::string& name) {
  const auto found = std::find_if(entries().begin(), entries().end(),
                                  [&](const Entry& entry) { return entry.name == name; });
  if (found != entries().end()) return *found;
  throw OptionError(fmt::format("--systems: unknown system '{}'; {}", name,
                                suggestion(name, odometry_system_names())));
}

double thread_cpu_seconds() {
  timespec time = {};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

/// Returns the CPU time of a call in this thread [s].
template <typename Call>
double cpu_time_of(const Call& call) {
  const double start = thread_cpu_seconds();
  call();
  return thread_cpu_seconds() - start;
}

std::optional<EvaluationReport> evaluation_of(const std::vector<StampedPose>& reference,
                                              const std::vector<StampedPose>& poses) {
  if (reference.empty()) return std::nullopt;
  try {
    return evaluate(reference, poses);
  } catch (const DataError&) {  // the reference covers another time
    return std::nullopt;
  }
}

std::optional<WrongFrames> wrong_frames(const std::vector<StampedPose>& reference,
                                        const std::vector<StampedPose>& tracked) {
  if (reference.empty() || tracked.empty()) return std::nullopt;
  try {
    const auto matches = associate(reference, tracked, {.interpolate = true});
    return WrongFrames{matches.size(), find_wrong_poses(matches)};
  } catch (const DataError&) {  // the reference covers another time
    return std::nullopt;
  }
}

/// One system while it runs through a sequence.
class Run {
 public:
  explicit Run(const Contestant& contestant) : system_(contestant.system.get()) {
    result_.name = contestant.name;
    result_.description = contestant.description;
    result_.built_in = system_ != nullptr;
  }

  void track(const RgbdFrame& frame) {
    if (system_ == nullptr) return;
    std::optional<SE3> T_world_camera;
    cpu_.push_back(cpu_time_of([&] { T_world_camera = system_->track(frame); }));
    add(frame.stamp, T_world_camera);
  }

  ContestantResult finish(const std::vector<StampedPose>& reference) {
    if (system_ != nullptr) {
      std::optional<Trajectory> path;
      result_.finish_cpu = cpu_time_of([&] { path = system_->finish(); });
      if (path) replace_poses(path->poses);
      result_.cpu = summarize(cpu_);
      result_.evaluation = evaluation_of(reference, result_.poses);
      result_.wrong = wrong_frames(reference, tracked_);
      result_.features_asked = system_->features_asked();
    }
    return std::move(result_);
  }

 private:
  /// Adds the pose of the next frame; a lost frame keeps the pose before it.
  void add(const Timestamp& stamp, const std::optional<SE3>& T_world_camera) {
    const SE3 before = result_.poses.empty() ? SE3() : result_.poses.back().T_world_camera;
    result_.poses.push_back({stamp, T_world_camera.value_or(before)});
    if (T_world_camera) {
      tracked_.push_back(result_.poses.back());
    } else {
      ++result_.lost;
    }
  }

  /// Takes poses that the system knows better now, in ascending order of stamps.
  void replace_poses(const std::vector<StampedPose>& path) {
    const std::vector<StampedPose> frames = std::move(result_.poses);
    result_.poses.clear();
    tracked_.clear();
    result_.lost = 0;
    auto next = path.begin();
    for (const StampedPose& frame : frames) {
      const bool known = next != path.end() && next->stamp == frame.stamp;
      add(frame.stamp, known ? std::optional(next->T_world_camera) : std::nullopt);
      if (known) ++next;
    }
  }

  OdometrySystem* system_;  // null if it is not built in
  ContestantResult result_;
  std::vector<StampedPose> tracked_;  // the poses of the frames that are not lost
  std::vector<double> cpu_;           // [s]
};

}  // namespace

std::unique_ptr<OdometrySystem> make_tracker_system(const Camera& camera,
                                                    const TrackerOptions& options) {
  return std::make_unique<TrackerSystem>(camera, options);
}

std::vector<std::string> odometry_system_names() {
  std::vector<std::string> names;
  for (const Entry& entry : entries()) names.push_back(entry.name);
  return names;
}

std::vector<Contestant> make_contestants(const std::vector<std::string>& names,
                                         const Camera& camera, const TrackerOptions& options) {
  std::vector<Contestant> contestants;
  for (const std::string& name : names) {
    const Entry& entry = find_entry(name);
    if (std::count(names.begin(), names.end(), name) > 1) {
      throw OptionError(fmt::format("--systems: '{}' is named twice; name each system once", name));
    }
    contestants.push_back({entry.name, entry.description, entry.make(camera, options)});
  }
  return contestants;
}

OdometryBenchmark run_odometry_benchmark(const Dataset& data, const FrameRange& frames,
                                         const std::vector<Contestant>& contestants,
                                         const BenchmarkProgress& progress) {
  std::vector<Run> runs(contestants.begin(), contestants.end());
  std::vector<double> decoding;
  for (std::size_t i = frames.begin; i < frames.end; i += frames.step) {
    RgbdFrame frame;
    decoding.push_back(cpu_time_of([&] { frame = data.read(i); }));
    for (auto& run : runs) run.track(frame);
    if (progress) progress(decoding.size(), frames.size());
  }
  OdometryBenchmark benchmark{frames, {}, summarize(decoding), {}};
  for (auto& run : runs) benchmark.results.push_back(run.finish(data.reference()));
  return benchmark;
}

}  // namespace cvo_slam
