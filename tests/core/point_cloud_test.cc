// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/core/point_cloud.h"

#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace cvo_slam {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

using Distortion = std::array<double, 5>;
constexpr Distortion kNone = {0, 0, 0, 0, 0};
constexpr Distortion kFr1 = {0.2624, -0.9531, -0.0054, 0.0026, 1.1633};  // TUM's freiburg1
constexpr Distortion kBarrel = {-0.2, 0, 0, 0, 0};
constexpr Distortion kStrongBarrel = {-0.3, 0, 0, 0, 0};  // not even its corners have a ray

/// Returns a Kinect with the given lens.
PinholeCamera camera_with(const Distortion& distortion) {
  return {640, 480, 517.3, 516.5, 318.6, 255.3, distortion};
}

/// Returns a point 2 m in front of the camera, `angle` [rad] to the right of its axis.
Vector3 point_at(double angle) { return {2 * std::tan(angle), 0, 2}; }

TEST(FieldOfView, EndsAtTheRimOfTheImage) {
  for (const Distortion& distortion : {kNone, kFr1, kBarrel}) {
    const PinholeCamera camera = camera_with(distortion);
    const FieldOfView view(camera);
    for (int u = 0; u < camera.width; u += 71) {
      for (const double v : {0.0, 240.0, 479.0}) {
        EXPECT_TRUE(view.contains(2 * camera.unproject({u, v}))) << u << " " << v;
      }
      EXPECT_FALSE(view.contains(2 * camera.unproject({u, -2}))) << u;
      EXPECT_FALSE(view.contains(2 * camera.unproject({u, 481}))) << u;
    }
  }
}

TEST(FieldOfView, HasNothingBehindTheCameraOrInIt) {
  const FieldOfView view(camera_with(kNone));
  EXPECT_TRUE(view.contains({0, 0, 0.2}));
  for (const double z : {0.05, 0.0, -2.0, std::nan("")}) EXPECT_FALSE(view.contains({0, 0, z}));
}

// Brown's polynomial leads points far off the axis back into the image: with the barrel lens, the
// ray 65.9 degrees off the axis ends in its very centre.
TEST(FieldOfView, DoesNotTrustThePolynomialFarOutsideTheImage) {
  for (const Distortion& distortion : {kFr1, kBarrel, kStrongBarrel}) {
    const PinholeCamera camera = camera_with(distortion);
    const FieldOfView view(camera);
    for (int degrees = 40; degrees < 90; ++degrees) {
      EXPECT_FALSE(view.contains(point_at(degrees * kDegree))) << degrees;
    }
  }
  const PinholeCamera barrel = camera_with(kBarrel);
  EXPECT_TRUE(barrel.contains(barrel.project(point_at(65.9 * kDegree))));
}

TEST(VisibleShare, IsThatOfTheFirstHundredPoints) {
  PointCloud cloud;
  EXPECT_EQ(visible_share(cloud, SE3(), FieldOfView(camera_with(kNone))), 0);
  for (int i = 0; i < 200; ++i) {
    // Every fourth of the first hundred is visible, and all that follow.
    const Vector3 p = point_at(i < 100 && i % 4 != 0 ? 70 * kDegree : 0);
    cloud.x.push_back(static_cast<float>(p.x()));
    cloud.y.push_back(static_cast<float>(p.y()));
    cloud.z.push_back(static_cast<float>(p.z()));
  }
  EXPECT_EQ(visible_share(cloud, SE3(), FieldOfView(camera_with(kNone))), 0.25);
  EXPECT_EQ(
      visible_share(cloud, SE3(Matrix3::Identity(), {0, 0, -3}), FieldOfView(camera_with(kNone))),
      0);
}

}  // namespace
}  // namespace cvo_slam
