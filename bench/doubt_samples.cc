// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Tracks recordings at their own and at lower frame rates and prints for each registration,
// believed or not, what the tracker knows of it and how wrong it is: the samples that
// bench/fit_doubt.py fits the tracker's doubt to.
//   doubt_samples [--depth-offset s] [--steps 1,2,4] [--features] [--frames N] sequence
#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cvo_slam/bench/report_errors.h"
#include "cvo_slam/core/association.h"
#include "cvo_slam/frontend/tracker.h"
#include "cvo_slam/frontend/tracking_doubt_internal.h"
#include "cvo_slam/io/dataset.h"
#include "cvo_slam/loop/loop_detector.h"
#include "cvo_slam/slam/feature_start_internal.h"
#include "cvo_slam/slam/slam_options.h"

namespace cvo_slam {
namespace {

struct Arguments {
  std::string sequence;
  std::vector<std::size_t> steps = {1, 2, 3, 4, 6, 8};
  double depth_offset = 0;
  std::size_t frames = 0;
  bool with_features = false;
};

void print_samples(const Dataset& data, std::size_t step, const Arguments& arguments) {
  const SlamOptions options;

  Tracker tracker(data.camera(), options.tracker);
  LoopDetector detector(data.camera(), options.loops.detection);
  AppearanceCache appearances(detector);
  FeatureStart start(data.camera(), options.loops.detection.verification, appearances);
  const StartFinder find_start = [&](const RgbdFrame& keyframe, const SE3& T_world_keyframe,
                                     const RgbdFrame& frame) {
    return start.find(keyframe, T_world_keyframe, frame);
  };
  FrameRecord last_tracked;
  const std::size_t end =
      arguments.frames > 0 ? std::min(arguments.frames, data.size()) : data.size();
  const auto truth_of = [&](std::size_t i) {
    constexpr double kMaxGap = 0.1;  // [s]
    return interpolate_at(data.reference(), data.stamp(i), kMaxGap);
  };
  for (std::size_t i = 0; i < end; i += step) {
    const auto [record, keyframe] =
        tracker.track(data.read(i), arguments.with_features ? find_start : StartFinder());
    if (keyframe) start.add(keyframe->images, last_tracked.T_world_camera);
    if (record.status == TrackingStatus::kTracked) {
      if (record.submap != last_tracked.submap) start.clear();
      last_tracked = record;
    }
    const RegistrationResult& result = record.registration;
    const auto truth = truth_of(i);
    const auto keyframe_truth = truth_of(record.keyframe);
    const auto known = last_evidence(tracker);
    if (known && truth && keyframe_truth) {
      const DoubtEvidence& e = *known;
      const SE3 error = (keyframe_truth->inverse() * *truth).inverse() * result.T_fixed_moving;
      fmt::print("{},{},{},{},{},{:.5f},{:.5f},{:.4f},{:.4f},{:.6f},{:.5f},{:.4f},{:.4f},{}\n",
                 data.name(), step, arguments.with_features ? 1 : 0, i,
                 record.status == TrackingStatus::kTracked ? 1 : 0, error.translation().norm(),
                 error.angle(), e.overlap, e.relative_cos_theta, e.sigma, e.surprise, e.seconds,
                 e.rival, static_cast<int>(e.features));
    }
  }
}

void run(const Arguments& arguments) {
  DatasetOptions options;
  options.depth_offset = arguments.depth_offset;
  const auto data = open_dataset(arguments.sequence, options);
  for (const std::size_t step : arguments.steps) print_samples(*data, step, arguments);
}

}  // namespace
}  // namespace cvo_slam

// NOLINTNEXTLINE(bugprone-exception-escape): options that are defined wrongly throw, no others
int main(int argc, char** argv) {
  cvo_slam::Arguments arguments;
  CLI::App app("Prints what the tracker knows of registrations and how wrong they are");
  app.add_option("sequence", arguments.sequence)->required();
  app.add_option("--steps", arguments.steps, "Every n-th frame, for each n")->delimiter(',');
  app.add_option("--depth-offset", arguments.depth_offset, "As in the program [s]");
  app.add_option("--frames", arguments.frames, "Only the first frames; 0 = all");
  app.add_flag("--features", arguments.with_features, "With starts found by features");
  CLI11_PARSE(app, argc, argv);
  return cvo_slam::report_errors([&] { cvo_slam::run(arguments); });
}
