// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/scene_files.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <numbers>
#include <sstream>
#include <string_view>
#include <utility>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/map.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/core/trajectory_errors.h"
#include "cvo_slam/io/g2o.h"
#include "cvo_slam/io/map_files.h"
#include "cvo_slam/io/ply.h"
#include "cvo_slam/io/trajectory_files.h"

namespace cvo_slam {
namespace {

constexpr std::array kPathColors = {kBlue, kVermilion, kGreen, kPurple, kOrange, kSkyBlue};
constexpr Color kReferenceColor{96, 96, 96};

template <typename T>
void move_to(std::vector<T>& all, std::vector<T>& added) {
  std::move(added.begin(), added.end(), std::back_inserter(all));
}

/// Returns the positions of a scene's poses.
std::vector<Vector3> pose_places(const render::MapScene& scene) {
  std::vector<Vector3> places;
  for (const SE3& keyframe : scene.keyframes) places.push_back(keyframe.translation());
  for (const render::Path& path : scene.paths) {
    for (const StampedPose& pose : path.poses) places.push_back(pose.T_world_camera.translation());
  }
  return places;
}

/// Adds the content of another scene. Points keep their origin if they are the first: moving them
/// would round them.
void append(render::MapScene& scene, render::MapScene added) {
  const std::vector<Vector3> places = pose_places(added);
  if (added.points.empty() && !places.empty()) set_origin(added, origin_near(places.front()));
  const bool is_first = scene.points.empty() && pose_places(scene).empty();
  if (is_first || (scene.points.empty() && !added.points.empty())) {
    set_origin(scene, added.origin);
  } else {
    set_origin(added, scene.origin);
  }
  move_to(scene.points, added.points);
  move_to(scene.paths, added.paths);
  move_to(scene.keyframes, added.keyframes);
  move_to(scene.constraints, added.constraints);
}

void add_path(render::MapScene& scene, std::string label, std::vector<StampedPose> poses) {
  const Color color = kPathColors[scene.paths.size() % kPathColors.size()];
  render::MapScene added;
  added.paths.push_back({std::move(label), std::move(poses), color});
  append(scene, std::move(added));
}

enum class FileKind { kPoints, kGraph, kTrajectory };

/// Returns the first word of a file that is not in a comment; empty if there is none near the
/// beginning or the file cannot be read.
std::string first_word(const std::filesystem::path& file) {
  std::string beginning(4096, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
  beginning.resize(static_cast<std::size_t>(stream.gcount()));
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (beginning.starts_with(kByteOrderMark)) beginning.erase(0, kByteOrderMark.size());
  std::istringstream lines(beginning);
  for (std::string line; std::getline(lines, line);) {
    std::string word;
    if (std::istringstream(line) >> word && word.front() != '#') return word;
  }
  return {};
}

FileKind kind_of(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension == ".ply") return FileKind::kPoints;
  if (extension == ".g2o") return FileKind::kGraph;
  const std::string word = first_word(file);
  if (word == "ply") return FileKind::kPoints;
  constexpr std::array<std::string_view, 4> kEntries = {"VERTEX", "EDGE", "PARAMS_", "FIX"};
  const bool is_graph = std::any_of(kEntries.begin(), kEntries.end(), [&](std::string_view entry) {
    return word.starts_with(entry);
  });
  return is_graph ? FileKind::kGraph : FileKind::kTrajectory;
}

/// Returns the map that is the points of a file.
Map map_of_points(PlyCloud cloud, std::vector<std::string>& notes) {
  move_to(notes, cloud.notes);
  Map map;
  map.points = std::move(cloud.points);
  map.points_origin = cloud.origin;
  return map;
}

/// Returns the z axis of the reference if it is near the estimated up direction, as in motion
/// capture; otherwise the estimate. Other references, as those of 7-Scenes, have no axis that
/// points up.
Vector3 up_of_reference(const Matrix3& R_scene_reference, const Vector3& estimated_up) {
  const Vector3 z = R_scene_reference.col(2);
  return z.dot(estimated_up) > std::numbers::sqrt2 / 2 ? z : estimated_up;
}

}  // namespace

void add_to_scene(render::MapScene& scene, const std::filesystem::path& input,
                  std::vector<std::string>& notes) {
  if (std::filesystem::is_directory(input)) {
    append(scene, render::make_scene(read_map(input, notes)));
    const auto trajectory = input / "trajectory.txt";
    if (std::filesystem::exists(trajectory)) {
      add_path(scene, "trajectory", read_tum_in_any_order(trajectory, notes));
    }
    return;
  }
  switch (kind_of(input)) {
    case FileKind::kPoints:
      append(scene, render::make_scene(map_of_points(read_ply(input), notes)));
      break;
    case FileKind::kGraph:
      append(scene, render::make_scene({{}, read_g2o(input, notes), {}}));
      break;
    case FileKind::kTrajectory:
      add_path(scene, input.stem().string(), read_tum_in_any_order(input, notes));
      break;
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
