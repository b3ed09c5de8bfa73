// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/scene_files.h"

#include <vector>

#include <gtest/gtest.h>

#include "cvo_slam/tests/core/trajectory_samples.h"

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

}  // namespace
}  // namespace cvo_slam
