// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/synthetic/rendering.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/synthetic/sequence.h"
#include "cvo_slam/tests/synthetic/plane_scene.h"

namespace cvo_slam::synthetic {
namespace {

const PinholeCamera kCamera = synthetic_camera(160, 120).color;

/// A lit scene of one primitive, seen from the origin along z.
WorldScene scene_of(const Shape& shape, const SE3& T_camera_shape) {
  WorldScene scene;
  scene.primitives.push_back({shape, T_camera_shape, plain(0.5)});
  scene.ambient = 1;
  return scene;
}

TEST(Render, DepthOfATiltedSheetIsThatOfItsPlane) {
  const SE3 T_camera_sheet(so3_exp({0.3, -0.5, 0.2}), {0.05, -0.02, 2});
  const Rendering rendering = render(scene_of(Rectangle{9, 9}, T_camera_sheet), kCamera, {});
  const Vector3 normal = T_camera_sheet.rotation().col(2);
  for (int y = 0; y < kCamera.height; y += 7) {
    for (int x = 0; x < kCamera.width; x += 7) {
      const Vector3 direction = kCamera.unproject({x, y});
      const double expected = normal.dot(T_camera_sheet.translation()) / normal.dot(direction);
      ASSERT_NEAR(rendering.depth.at<double>(y, x), expected, 1e-12);
    }
  }
}

TEST(Render, SeesTheFrontOfABoxAndNothingBesideIt) {
  // The front face spans x, y in [-0.5, 0.5] at z = 2, which is 32.8 px to each side.
  const WorldScene scene = scene_of(Box{{1, 1, 2}}, SE3(Matrix3::Identity(), {0, 0, 3}));
  const Rendering rendering = render(scene, kCamera, {});
  EXPECT_NEAR(rendering.depth.at<double>(60, 80), 2, 1e-12);
  EXPECT_NEAR(rendering.color.at<cv::Vec3f>(60, 80)[1], 127.5, 1e-4);
  EXPECT_EQ(rendering.depth.at<double>(60, 80 + 40), 0);
  EXPECT_EQ(rendering.color.at<cv::Vec3f>(60, 80 + 40), cv::Vec3f(0, 0, 0));
}

TEST(Render, ARayExactlyAlongASlabIsNotLost) {
  // An odd image has a pixel whose ray is exactly (0, 0, 1): two slabs are parallel to it.
  const PinholeCamera camera = synthetic_camera(161, 121).color;
  const auto depth_of_box_at = [&](double x) {
    const WorldScene scene = scene_of(Box{{1, 1, 1}}, SE3(Matrix3::Identity(), {x, 0, 3}));
    return render(scene, camera, {}).depth.at<double>(60, 80);
  };
  EXPECT_NEAR(depth_of_box_at(0.1), 2.5, 1e-12);
  EXPECT_EQ(depth_of_box_at(0.7), 0);
}

TEST(Render, TheRimOfASurfaceIsBlended) {
  const WorldScene scene = scene_of(Rectangle{1, 1}, SE3(so3_exp({0, 0, 0.3}), {0, 0, 2}));
  const Rendering rendering = render(scene, kCamera, {});
  const auto blended =
      std::count_if(rendering.color.begin<cv::Vec3f>(), rendering.color.end<cv::Vec3f>(),
                    [](const cv::Vec3f& c) { return c[0] > 1 && c[0] < 126; });
  // Most of the rim's 4 * 65 px; a point-sampled picture has none.
  EXPECT_GT(blended, 150);
}

TEST(Render, RefusesACameraWithDistortion) {
  PinholeCamera camera = kCamera;
  camera.distortion[0] = 0.1;
  EXPECT_THROW(static_cast<void>(render(WorldScene{}, camera, {})), OptionError);
}

}  // namespace
}  // namespace cvo_slam::synthetic
