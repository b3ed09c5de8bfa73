// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/scene_files.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/trajectory_errors.h"
#include "cvo_slam/io/g2o.h"
#include "cvo_slam/io/map_files.h"
#include "cvo_slam/io/ply.h"
#include "cvo_slam/io/trajectory_files.h"

namespace cvo_slam {
namespace {

constexpr std::array kPathColors = {kBlue, kVermilion, kGreen, kPurple, kOrange, kSkyBlue};
constexpr Color kReferenceColor{96, 96, 96};

void append(render::MapScene& scene, const Map& map) {
  render::MapScene added = render::make_scene(map);
  std::move(added.points.begin(), added.points.end(), std::back_inserter(scene.points));
  std::move(added.keyframes.begin(), added.keyframes.end(), std::back_inserter(scene.keyframes));
  std::move(added.constraints.begin(), added.constraints.end(),
            std::back_inserter(scene.constraints));
}

void add_path(render::MapScene& scene, std::string label, std::vector<StampedPose> poses) {
  const Color color = kPathColors[scene.paths.size() % kPathColors.size()];
  scene.paths.push_back({std::move(label), std::move(poses), color});
}

/// Returns the z axis of the reference if it is near the estimated up direction, as in motion
/// capture; otherwise the estimate. Other references, as those of 7-Scenes, have no axis that
/// points up.
Vector3 up_of_reference(const Matrix3& R_scene_reference, const Vector3& estimated_up) {
  const Vector3 z = R_scene_reference.col(2);
  return z.dot(estimated_up) > std::numbers::sqrt2 / 2 ? z : estimated_up;
}

}  // namespace

void add_to_scene(render::MapScene& scene, const std::filesystem::path& input) {
  std::vector<std::string> notes;
  const auto extension = input.extension();
  if (std::filesystem::is_directory(input)) {
    append(scene, read_map(input));
    const auto trajectory = input / "trajectory.txt";
    if (std::filesystem::exists(trajectory)) {
      add_path(scene, "trajectory", read_tum_in_any_order(trajectory, notes));
    }
  } else if (extension == ".ply") {
    append(scene, {{}, {}, read_ply(input)});
  } else if (extension == ".g2o") {
    append(scene, {{}, read_g2o(input), {}});
  } else {
    add_path(scene, input.stem().string(), read_tum_in_any_order(input, notes));
  }
}

void add_reference(render::MapScene& scene, const std::vector<StampedPose>& reference,
                   PathColor color) {
  if (scene.paths.empty()) throw DataError("no trajectory that the reference could be fitted to");
  render::Path& path = scene.paths.front();
  const auto error = absolute_trajectory_error(associate(reference, path.poses));
  const SE3 T_scene_reference = error.alignment.T_reference_estimate.inverse();
  scene.up = up_of_reference(T_scene_reference.rotation(), scene.up);
  if (color == PathColor::kError) {
    constexpr double kMillimetres = 1000;
    std::map<Timestamp, double> values;
    for (const PoseError& pose : error.errors) values[pose.stamp] = kMillimetres * pose.translation;
    path.values.clear();
    for (const StampedPose& pose : path.poses) {
      const auto value = values.find(pose.stamp);
      path.values.push_back(value == values.end() ? std::numeric_limits<double>::quiet_NaN()
                                                  : value->second);
    }
    scene.value_label = "error [mm]";
  }
  render::Path truth{"ground truth", {}, kReferenceColor};
  for (const StampedPose& pose : reference) {
    if (pose.stamp < path.poses.front().stamp || path.poses.back().stamp < pose.stamp) continue;
    truth.poses.push_back({pose.stamp, T_scene_reference * pose.T_world_camera});
  }
  scene.paths.push_back(std::move(truth));
}

}  // namespace cvo_slam
