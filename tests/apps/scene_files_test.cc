// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/scene_files.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cvo_slam/tests/core/trajectory_samples.h"
#include "cvo_slam/tests/temporary_folder.h"

namespace cvo_slam {
namespace {

/// A path in the frame of its first camera, whose -y is nearly up.
render::MapScene scene_of(const std::vector<StampedPose>& path) {
  render::MapScene scene;
  scene.up = Vector3(0.1, -1, 0).normalized();
  scene.paths.push_back({"trajectory", path, kBlue});
  return scene;
}

TEST(AddReference, TakesTheUpOfMotionCapture) {
  const auto path = helix(20);
  const SE3 T_upright_world(Matrix3{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}}, {1, 2, 3});
  auto reference = path;
  for (auto& pose : reference) pose.T_world_camera = T_upright_world * pose.T_world_camera;
  render::MapScene scene = scene_of(path);
  add_reference(scene, reference, PathColor::kTime);
  EXPECT_LT((scene.up - Vector3(0, -1, 0)).norm(), 1e-6) << "its z, in the path's world";
  ASSERT_EQ(scene.paths.size(), 2U);
}

// The true poses of 7-Scenes are in the frame of a camera: the map once lay on its back.
TEST(AddReference, DoesNotTakeAnAxisAheadForUp) {
  const auto path = helix(20);
  render::MapScene scene = scene_of(path);
  const Vector3 estimated = scene.up;
  add_reference(scene, path, PathColor::kTime);
  EXPECT_EQ(scene.up, estimated);
}

const std::string kFarPoints =
    "ply\nformat ascii 1.0\nelement vertex 2\nproperty double x\nproperty double y\n"
    "property double z\nend_header\n400000.25 5000000 0\n400000.26 5000000 0\n";

// Points are floats: only they need the origin, whatever was added before them.
TEST(AddToScene, ThePointsThatComeFirstKeepTheirOrigin) {
  const TemporaryFolder folder;
  const auto far = folder.write("far.ply", kFarPoints);
  const auto path = folder.write("path.txt", "0 1 2 3 0 0 0 1\n");
  for (const auto& inputs : {std::vector{path, far}, std::vector{far, path}}) {
    render::MapScene scene;
    std::vector<std::string> notes;
    for (const auto& input : inputs) add_to_scene(scene, input, notes);
    EXPECT_TRUE(notes.empty());
    EXPECT_EQ(scene.origin, Vector3(400000, 5000000, 0));
    EXPECT_NEAR(scene.points.at(1).position.x() - scene.points.at(0).position.x(), 0.01, 1e-6);
    EXPECT_EQ(scene.paths.at(0).poses.at(0).T_world_camera.translation(),
              Vector3(1 - 400000, 2 - 5000000, 3));
  }
}

TEST(AddToScene, GraphsAndPathsFarFromZeroGetAnOrigin) {
  const TemporaryFolder folder;
  const auto graph = folder.write("graph", "VERTEX_SE3:QUAT 0 400001 5000002 3 0 0 0 1\n");
  const auto path = folder.write("path.txt", "0 400004 5000005 6 0 0 0 1\n");
  render::MapScene scene;
  std::vector<std::string> notes;
  add_to_scene(scene, graph, notes);
  add_to_scene(scene, path, notes);
  EXPECT_EQ(scene.origin, Vector3(400000, 5000000, 0));
  EXPECT_EQ(scene.keyframes.at(0).translation(), Vector3(1, 2, 3));
  EXPECT_EQ(scene.paths.at(0).poses.at(0).T_world_camera.translation(), Vector3(4, 5, 6));
}

}  // namespace
}  // namespace cvo_slam
