// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/run_map.h"

#include <map>

#include "cvo_slam/apps/scene_files.h"
#include "cvo_slam/core/error.h"
#include "cvo_slam/io/map_files.h"
#include "cvo_slam/render/picture.h"

namespace cvo_slam {
namespace {

std::map<Timestamp, SE3> poses_by_stamp(const Trajectory& trajectory) {
  std::map<Timestamp, SE3> poses;
  for (const StampedPose& pose : trajectory.poses) poses.emplace(pose.stamp, pose.T_world_camera);
  return poses;
}

/// Returns none if the run went on from a map, because the stamps of two runs are in no order.
std::vector<StampedPose> graph_keyframes(const GraphResult& graph) {
  std::vector<StampedPose> keyframes;
  if (graph.first_number > 0) return keyframes;
  for (const Keyframe& keyframe : graph.keyframes) {
    keyframes.push_back({keyframe.stamp, keyframe.T_world_camera});
  }
  return keyframes;
}

/// Returns the poses of the frames that became keyframes, in mode odometry.
std::vector<StampedPose> tracked_keyframes(const OdometryRun& run,
                                           const std::map<Timestamp, SE3>& poses) {
  std::vector<StampedPose> keyframes;
  for (const FrameRecord& record : run.records) {
    const auto pose = poses.find(record.stamp);
    if (record.keyframe_reason.empty() || pose == poses.end()) continue;
    keyframes.push_back({record.stamp, pose->second});
  }
  return keyframes;
}

/// Makes a scene of the map, the path and the reference.
render::MapScene make_run_scene(const Map& map, const Trajectory& trajectory,
                                const std::vector<StampedPose>& reference,
                                std::vector<std::string>& notes) {
  render::MapScene scene = render::make_scene(map);
  render::add_path_by_time(scene, "trajectory", trajectory.poses);
  if (reference.empty() || trajectory.poses.empty()) return scene;
  try {
    add_reference(scene, reference, PathColor::kTime);
  } catch (const DataError& error) {
    notes.push_back(std::string("map.png without ground truth: ") + error.what());
  }
  return scene;
}

/// Smaller than the pictures of `cvo_slam render`, because every run pays for it.
constexpr render::ViewOptions kView = {.width = 1280, .height = 720};

}  // namespace

RunMap make_run_map(const OdometryRun& run, const std::optional<GraphResult>& graph,
                    const Trajectory& trajectory, const Camera& camera,
                    const FusionOptions& options, int threads) {
  const double start = process_cpu_seconds();
  const auto poses = poses_by_stamp(trajectory);
  RunMap result;
  result.map.keyframes = graph ? graph_keyframes(*graph) : tracked_keyframes(run, poses);
  if (graph) result.map.graph = graph->graph;
  std::vector<PosedFrame> frames;
  for (const SampledFrame& frame : run.kept_keyframes) {
    const auto pose = poses.find(frame.stamp);
    if (pose != poses.end()) frames.push_back({frame, pose->second});
  }
  result.has_points = !run.kept_keyframes.empty();
  result.map.points = fuse_points(frames, camera, options, Executor(threads));
  result.cpu_seconds = process_cpu_seconds() - start;
  return result;
}

cv::Mat write_run_map(const std::filesystem::path& folder, RunMap& run_map,
                      const Trajectory& trajectory, const std::vector<StampedPose>& reference,
                      std::vector<std::string>& notes) {
  const double start = process_cpu_seconds();
  write_map(folder, run_map.map);
  if (!run_map.has_points) return {};
  const render::MapScene scene = make_run_scene(run_map.map, trajectory, reference, notes);
  const auto renderer = render::make_renderer();
  const render::Picture picture = render::draw_picture(scene, kView, *renderer);
  for (const auto& note : picture.notes) notes.push_back("map.png: " + note);
  render::write_picture(folder / "map.png", picture.image);
  run_map.renderer = renderer->name();
  run_map.cpu_seconds += process_cpu_seconds() - start;
  return picture.image;
}

}  // namespace cvo_slam
