// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Measures what a picture of 1920x1080 pixels of a map of a million points costs, and what fusing
// the points of a map costs.
#include <benchmark/benchmark.h>

#include "cvo_slam/core/map.h"
#include "cvo_slam/render/picture.h"
#include "cvo_slam/synthetic/rendering.h"
#include "cvo_slam/synthetic/sequence.h"
#include "cvo_slam/synthetic/world.h"

namespace cvo_slam {
namespace {

/// Returns frames of the synthetic room, half a second apart.
std::vector<PosedFrame> room_frames(const Camera& camera, int pixel_step) {
  constexpr int kFrames = 20;
  const synthetic::World world = synthetic::make_world("room");
  std::vector<PosedFrame> frames;
  for (int i = 0; i < kFrames; ++i) {
    const SE3 pose = world.path.T_world_camera(0.5 * i);
    const auto rendering = synthetic::render(world.scene, camera.color, pose);
    RgbdFrame frame;
    rendering.color.convertTo(frame.color, CV_8U);
    rendering.depth.convertTo(frame.depth, CV_16U, camera.depth_scale);
    frames.push_back({sample_frame(frame, pixel_step), pose});
  }
  return frames;
}

void fuse_room(benchmark::State& state) {
  const Camera camera = synthetic::synthetic_camera(640, 480);
  const FusionOptions options;
  const auto frames = room_frames(camera, options.pixel_step);
  for ([[maybe_unused]] auto iteration : state) {
    benchmark::DoNotOptimize(fuse_points(frames, camera, options));
  }
}
BENCHMARK(fuse_room)->Unit(benchmark::kMillisecond);

/// Returns the room with voxels of 5 mm: about a million points.
render::MapScene large_scene() {
  const Camera camera = synthetic::synthetic_camera(640, 480);
  render::MapScene scene;
  scene.up = Vector3::UnitZ();
  const FusionOptions options{.pixel_step = 1, .voxel_size = 0.005, .min_samples = 1};
  scene.points = fuse_points(room_frames(camera, 1), camera, options);
  scene.points.resize(1'000'000, scene.points.back());
  return scene;
}

void draw_million(benchmark::State& state, render::RendererKind kind) {
  static const render::MapScene scene = large_scene();
  for ([[maybe_unused]] auto iteration : state) {
    const auto renderer = render::make_renderer(kind);
    benchmark::DoNotOptimize(
        render::draw_picture(scene, {.width = 1920, .height = 1080}, *renderer));
  }
}
BENCHMARK_CAPTURE(draw_million, osmesa, render::RendererKind::kOsmesa)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(draw_million, splat, render::RendererKind::kSplat)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();

}  // namespace
}  // namespace cvo_slam
