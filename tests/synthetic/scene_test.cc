// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/synthetic/scene.h"

#include <gtest/gtest.h>

#include "cvo_slam/core/error.h"

namespace cvo_slam::synthetic {
namespace {

Scene swinging_box() {
  Scene scene;
  scene.primitives.push_back(
      {Box{}, SE3(Matrix3::Identity(), {1, 2, 3}), {}, Swing{{0, 4, 0}, 2, 0}});
  scene.primitives.push_back({Box{}, SE3(Matrix3::Identity(), {5, 5, 5}), {}, {}});
  return scene;
}

TEST(Scene, WhatSwingsIsOutAfterAQuarterPeriodAndBackAfterAHalf) {
  const Scene scene = swinging_box();
  const auto y_at = [&](double seconds) {
    return scene_at(scene, seconds).primitives[0].T_world_shape.translation().y();
  };
  EXPECT_NEAR(y_at(0), 2, 1e-12);
  EXPECT_NEAR(y_at(0.5), 6, 1e-12);
  EXPECT_NEAR(y_at(1), 2, 1e-12);
  EXPECT_NEAR(y_at(1.5), -2, 1e-12);
}

TEST(Scene, WhatIsAtRestStaysWhereItIs) {
  const Scene later = scene_at(swinging_box(), 0.5);
  EXPECT_EQ(later.primitives[1].T_world_shape.translation(), Vector3(5, 5, 5));
  EXPECT_FALSE(later.primitives[0].swing.has_value());
}

TEST(Scene, ASwingWithoutAPeriodIsRefused) {
  Scene scene = swinging_box();
  scene.primitives[0].swing->period = 0;
  EXPECT_THROW(check(scene), OptionError);
}

}  // namespace
}  // namespace cvo_slam::synthetic
