// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/synthetic/world_scene.h"

#include <gtest/gtest.h>

#include "cvo_slam/core/error.h"

namespace cvo_slam::synthetic {
namespace {

WorldScene swinging_box() {
  WorldScene scene;
  scene.primitives.push_back(
      {Box{}, SE3(Matrix3::Identity(), {1, 2, 3}), {}, Swing{{0, 4, 0}, 2, 0}});
  scene.primitives.push_back({Box{}, SE3(Matrix3::Identity(), {5, 5, 5}), {}, {}});
  return scene;
}

TEST(WorldScene, WhatSwingsIsOutAfterAQuarterPeriodAndBackAfterAHalf) {
  const WorldScene scene = swinging_box();
  const auto y_at = [&](double seconds) {
    return scene_at(scene, seconds).primitives[0].T_world_shape.translation().y();
  };
  EXPECT_NEAR(y_at(0), 2, 1e-12);
  EXPECT_NEAR(y_at(0.5), 6, 1e-12);
  EXPECT_NEAR(y_at(1), 2, 1e-12);
  EXPECT_NEAR(y_at(1.5), -2, 1e-12);
}

TEST(WorldScene, WhatIsAtRestStaysWhereItIs) {
  const WorldScene later = scene_at(swinging_box(), 0.5);
  EXPECT_EQ(later.primitives[1].T_world_shape.translation(), Vector3(5, 5, 5));
  EXPECT_FALSE(later.primitives[0].swing.has_value());
}

TEST(WorldScene, ASwingWithoutAPeriodIsRefused) {
  WorldScene scene = swinging_box();
  scene.primitives[0].swing->period = 0;
  EXPECT_THROW(check(scene), OptionError);
}

TEST(WorldScene, ClearanceIsTheDistanceToTheNearestSurface) {
  WorldScene scene;
  scene.primitives.push_back({Box{{2, 2, 2}}, SE3(Matrix3::Identity(), {3, 0, 0}), {}});
  scene.primitives.push_back({Rectangle{1, 1}, SE3(Matrix3::Identity(), {0, 0, 5}), {}});
  EXPECT_DOUBLE_EQ(clearance(scene, {0, 0, 0}), 2);
  EXPECT_DOUBLE_EQ(clearance(scene, {3.2, 0.1, 0}), 0);
  EXPECT_DOUBLE_EQ(clearance(scene, {0, 0, 4.5}), 0.5);
}

TEST(WorldScene, ImpossibleValuesAreRefused) {
  WorldScene scene;
  scene.primitives.push_back({Box{{1, -1, 1}}, {}, {}});
  EXPECT_THROW(check(scene), OptionError);
  scene.primitives[0].shape = Rectangle{1, 0};
  EXPECT_THROW(check(scene), OptionError);
  scene.primitives[0].shape = Box{};
  EXPECT_NO_THROW(check(scene));
  scene.lights.push_back({{0, 0, 0}, -1});
  EXPECT_THROW(check(scene), OptionError);
}

}  // namespace
}  // namespace cvo_slam::synthetic
