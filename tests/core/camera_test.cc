// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/core/camera.h"

#include <cmath>

#include <gtest/gtest.h>

#include "cvo_slam/core/error.h"

namespace cvo_slam {
namespace {

PinholeCamera distorted_camera() {
  PinholeCamera camera;
  camera.fx = 517.3;
  camera.fy = 516.5;
  camera.cx = 318.6;
  camera.cy = 255.3;
  camera.distortion = {0.2624, -0.9531, -0.0054, 0.0026, 1.1633};
  return camera;
}

TEST(PinholeCamera, UnprojectInvertsProjectAllOverTheImage) {
  PinholeCamera flipped;
  flipped.fy = -480;  // ICL-NUIM
  for (const PinholeCamera& camera : {PinholeCamera(), distorted_camera(), flipped}) {
    for (int v = 0; v < camera.height; v += 20) {
      for (int u = 0; u < camera.width; u += 20) {
        const Eigen::Vector2d pixel(u, v);
        EXPECT_LT((camera.project(2.5 * camera.unproject(pixel)) - pixel).norm(), 1e-6);
      }
    }
  }
}

TEST(PinholeCamera, ThePrincipalPointLooksAlongTheAxis) {
  const PinholeCamera camera = distorted_camera();
  EXPECT_LT((camera.project(Vector3(0, 0, 3)) - Eigen::Vector2d(camera.cx, camera.cy)).norm(),
            1e-12);
}

TEST(PinholeCamera, DistortionIsBrownsModel) {
  PinholeCamera camera;
  camera.fx = camera.fy = 1;
  camera.cx = camera.cy = 0;
  camera.distortion = {0.1, 0.01, 0.001, 0.002, 0.0001};
  const double x = 0.3, y = -0.2, r2 = x * x + y * y;
  const double radial = 1 + 0.1 * r2 + 0.01 * r2 * r2 + 0.0001 * r2 * r2 * r2;
  const Eigen::Vector2d pixel = camera.project(Vector3(x, y, 1));
  EXPECT_NEAR(pixel.x(), x * radial + 2 * 0.001 * x * y + 0.002 * (r2 + 2 * x * x), 1e-15);
  EXPECT_NEAR(pixel.y(), y * radial + 0.001 * (r2 + 2 * y * y) + 2 * 0.002 * x * y, 1e-15);
}

TEST(PinholeCamera, ContainsReachesHalfAPixelBeyondTheCentres) {
  const PinholeCamera camera;
  EXPECT_TRUE(camera.contains({-0.4, 479.4}));
  EXPECT_FALSE(camera.contains({-0.6, 0}));
  EXPECT_FALSE(camera.contains({639.6, 0}));
}

TEST(Camera, CheckRejectsImpossibleValues) {
  Camera camera;
  EXPECT_NO_THROW(camera.check());
  camera.depth_scale = 0;
  EXPECT_THROW(camera.check(), OptionError);
  camera = Camera();
  camera.color.fx = std::nan("");
  EXPECT_THROW(camera.check(), OptionError);
  camera = Camera();
  camera.depth = DepthCamera();
  camera.depth->pinhole.height = 0;
  EXPECT_THROW(camera.check(), OptionError);
}

}  // namespace
}  // namespace cvo_slam
