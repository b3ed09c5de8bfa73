// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Measures what one frame costs, step by step, on two neighbouring frames of the synthetic room.
#include <benchmark/benchmark.h>
#include <opencv2/core.hpp>

#include "cvo_slam/core/timestamp.h"
#include "cvo_slam/frontend/point_selection.h"
#include "cvo_slam/frontend/registration.h"
#include "cvo_slam/frontend/tracker.h"
#include "cvo_slam/synthetic/rendering.h"
#include "cvo_slam/synthetic/sequence.h"
#include "cvo_slam/synthetic/world.h"

namespace cvo_slam {
namespace {

constexpr double kFramePeriod = 1.0 / 30;  // [s]

const Camera& camera() {
  static const Camera camera = synthetic::synthetic_camera(640, 480);
  return camera;
}

RgbdFrame render_frame(const synthetic::World& world, double seconds) {
  const auto rendering =
      synthetic::render(world.scene, camera().color, world.path.T_world_camera(seconds));
  RgbdFrame frame;
  frame.stamp = frame.depth_stamp = Timestamp::from_seconds(seconds);
  rendering.color.convertTo(frame.color, CV_8UC3);
  rendering.depth.convertTo(frame.depth, CV_16U, camera().depth_scale);
  return frame;
}

/// Two consecutive frames.
struct FramePair {
  RgbdFrame fixed;
  RgbdFrame moving;
};

const FramePair& frames() {
  static const FramePair pair = [] {
    const auto world = synthetic::make_world("room");
    return FramePair{render_frame(world, 0), render_frame(world, kFramePeriod)};
  }();
  return pair;
}

/// The clouds that a tracker with some options would register.
struct Clouds {
  explicit Clouds(const TrackerOptions& options)
      : fixed(select_points(frames().fixed, camera(), options.keyframe_points, options.selection)),
        moving(select_points(frames().moving, camera(), options.points, options.selection)) {}

  PointCloud fixed;
  PointCloud moving;
};

void select_points_of_a_frame(benchmark::State& state) {
  const int count = static_cast<int>(state.range(0));
  const RgbdFrame& frame = frames().moving;  // rendered before the measurement
  for ([[maybe_unused]] auto iteration : state) {
    benchmark::DoNotOptimize(select_points(frame, camera(), count));
  }
}
BENCHMARK(select_points_of_a_frame)
    ->Arg(TrackerOptions().points)
    ->Arg(TrackerOptions().keyframe_points)
    ->Unit(benchmark::kMillisecond);

void set_fixed(benchmark::State& state, const TrackerOptions& options) {
  const Clouds clouds(options);
  Registration registration(options.registration);
  for ([[maybe_unused]] auto iteration : state) registration.set_fixed(clouds.fixed);
  state.counters["points"] = static_cast<double>(clouds.fixed.size());
}
BENCHMARK_CAPTURE(set_fixed, newton, TrackerOptions())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(set_fixed, flow, paper_options())->Unit(benchmark::kMillisecond);

/// Starts at the identity, which is the motion of a whole frame away from the result.
void align_to_fixed(benchmark::State& state, const TrackerOptions& options) {
  const Clouds clouds(options);
  Registration registration(options.registration);
  registration.set_fixed(clouds.fixed);
  RegistrationResult result;
  for ([[maybe_unused]] auto iteration : state) {
    result = registration.align(clouds.moving, SE3());
    benchmark::DoNotOptimize(result);
  }
  state.counters["iterations"] = result.iterations;
  state.counters["points"] = static_cast<double>(clouds.moving.size());
}
BENCHMARK_CAPTURE(align_to_fixed, newton, TrackerOptions())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(align_to_fixed, flow, paper_options())->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace cvo_slam
