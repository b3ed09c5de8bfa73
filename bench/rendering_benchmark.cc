// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Measures what a frame of 640x480 pixels of the synthetic room costs, without writing it to a
// file.
#include <benchmark/benchmark.h>

#include "cvo_slam/synthetic/rendering.h"
#include "cvo_slam/synthetic/sensor.h"
#include "cvo_slam/synthetic/sequence.h"
#include "cvo_slam/synthetic/world.h"

namespace cvo_slam::synthetic {
namespace {

/// Time from a frame to the next, so that the mean is over near and far, smooth and cluttered
/// views.
constexpr double kStep = 0.7;  // [s]

void render_frames(benchmark::State& state) {
  const World world = make_world("room");
  const Camera camera = synthetic_camera(640, 480);
  double seconds = 0;
  for ([[maybe_unused]] auto iteration : state) {
    benchmark::DoNotOptimize(render(world.scene, camera.color, world.path.T_world_camera(seconds)));
    seconds += kStep;
  }
}
BENCHMARK(render_frames)->Unit(benchmark::kMillisecond)->Iterations(15);

void capture_frames(benchmark::State& state, const SensorOptions& options) {
  const World world = make_world("room");
  const Sensor sensor(
      world.scene, [&](double seconds) { return world.path.T_world_camera(seconds); },
      world.path.duration(), synthetic_camera(640, 480), options, 1);
  std::size_t frame = 0;
  for ([[maybe_unused]] auto iteration : state) {
    const double seconds = kStep * static_cast<double>(frame);
    benchmark::DoNotOptimize(sensor.capture(frame++, {.color = seconds, .depth = seconds + 0.01}));
  }
}

SensorOptions without_blur(const char* preset) {
  SensorOptions options = sensor_preset(preset);
  options.exposure.time = 0;
  return options;
}

BENCHMARK_CAPTURE(capture_frames, none, sensor_preset("none"))
    ->Unit(benchmark::kMillisecond)
    ->Iterations(15);
BENCHMARK_CAPTURE(capture_frames, kinect_without_blur, without_blur("kinect"))
    ->Unit(benchmark::kMillisecond)
    ->Iterations(15);
BENCHMARK_CAPTURE(capture_frames, kinect, sensor_preset("kinect"))
    ->Unit(benchmark::kMillisecond)
    ->Iterations(15);
BENCHMARK_CAPTURE(capture_frames, harsh, sensor_preset("harsh"))
    ->Unit(benchmark::kMillisecond)
    ->Iterations(15);

}  // namespace
}  // namespace cvo_slam::synthetic
