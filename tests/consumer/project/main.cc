// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A program of somebody else: it writes a trajectory into the folder it is given, reads it back,
// sees the errors of the library as exceptions of its own, and asks the tracker. With an installed
// package it also asks the loop detector and optimises a pose graph; as a subdirectory these
// libraries would be compiled for this test alone.
#include <filesystem>
#include <iostream>
#include <numbers>
#include <typeinfo>

#include <cvo_slam/core/error.h>
#include <cvo_slam/core/se3.h>
#include <cvo_slam/frontend/tracker.h>
#include <cvo_slam/io/dataset.h>
#include <cvo_slam/io/trajectory_files.h>
#ifdef CONSUMER_USES_EVERY_LIBRARY
#include <cvo_slam/backend/optimizer.h>
#include <cvo_slam/core/pose_graph.h>
#include <cvo_slam/loop/loop_detector.h>
#endif

namespace {

cvo_slam::Trajectory quarter_turns() {
  cvo_slam::Vector6 tangent;
  tangent << 1, 0, 0, 0, 0, std::numbers::pi / 2;
  const cvo_slam::SE3 step = cvo_slam::SE3::exp(tangent);
  cvo_slam::Trajectory trajectory;
  cvo_slam::SE3 pose;
  for (int second = 0; second <= 4; ++second) {
    trajectory.poses.push_back({cvo_slam::Timestamp::from_seconds(second), pose});
    pose = pose * step;
  }
  return trajectory;
}

bool missing_file_throws(const std::filesystem::path& folder) {
  try {
    static_cast<void>(cvo_slam::read_tum(folder / "no_such_file.txt"));
  } catch (const cvo_slam::InputError&) {
    return true;
  }
  return false;
}

/// Types of the library are known to the program, wherever the library is.
bool types_are_known() {
  const cvo_slam::InputError error("a.txt", "is broken");
  const std::exception* base = &error;
  return dynamic_cast<const cvo_slam::InputError*>(base) != nullptr &&
         typeid(cvo_slam::FramePrefetcher) != typeid(cvo_slam::FrameSource);
}

/// A frame without images is an answer, not an exception.
bool tracker_answers() {
  cvo_slam::Tracker tracker{cvo_slam::Camera()};
  const cvo_slam::FrameRecord record = tracker.track(cvo_slam::RgbdFrame()).record;
  return record.status == cvo_slam::TrackingStatus::kLost && !record.reason.empty();
}

#ifdef CONSUMER_USES_EVERY_LIBRARY
/// The vocabulary comes with the library: there is no file to find.
bool loop_detector_answers() {
  cvo_slam::LoopDetector detector{cvo_slam::Camera()};
  const auto nothing = detector.extract(cvo_slam::RgbdFrame());
  detector.add(nothing);
  return detector.size() == 1 && detector.find_loops(*nothing).empty();
}

/// The optimum of two measurements that differ is the middle.
bool optimizer_answers() {
  const cvo_slam::Matrix3 straight = cvo_slam::Matrix3::Identity();
  cvo_slam::PoseGraph graph;
  graph.add_node({0, cvo_slam::SE3()});
  graph.add_node({1, cvo_slam::SE3()});
  graph.add_edge({0, 1, cvo_slam::SE3(straight, {1, 0, 0})});
  graph.add_edge({0, 1, cvo_slam::SE3(straight, {3, 0, 0})});
  const cvo_slam::Summary summary = cvo_slam::optimize(graph);
  const cvo_slam::Vector3 middle(2, 0, 0);
  return summary.converged && (graph.nodes()[1].T_world_node.translation() - middle).norm() < 1e-6;
}

bool other_libraries_answer() { return loop_detector_answers() && optimizer_answers(); }
#else
bool other_libraries_answer() { return true; }
#endif

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::filesystem::path folder = argv[1];
  cvo_slam::write_tum(folder / "trajectory.txt", quarter_turns());
  const auto poses = cvo_slam::read_tum(folder / "trajectory.txt");

  // Four quarter turns of a circle end where they began, up to the nine digits of the file.
  const double gap = poses.back().T_world_camera.translation().norm();
  const bool ok = poses.size() == 5 && gap < 1e-8 && missing_file_throws(folder) &&
                  types_are_known() && tracker_answers() && other_libraries_answer();
  std::cout << poses.size() << " poses, the gap of the circle is " << gap << " m\n";
  return ok ? 0 : 1;
}
