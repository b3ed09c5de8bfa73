// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Points of a frame whose depth image was taken from elsewhere than its colour image.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include <gtest/gtest.h>

#include "cvo_slam/frontend/point_selection.h"
#include "cvo_slam/tests/frontend/test_clouds.h"
#include "cvo_slam/tests/frontend/test_frames.h"

namespace cvo_slam {
namespace {

/// A slanted wall in the colour camera's frame: normal . p = distance.
const Vector3 kNormal = Vector3(0.15, -0.1, 1).normalized();
constexpr double kDistance = 1.5;

/// Returns the depth image of the wall from T_color_depth.
cv::Mat wall_from(const Camera& camera, const SE3& T_color_depth) {
  const Vector3 normal = T_color_depth.rotation().transpose() * kNormal;
  const double distance = kDistance - kNormal.dot(T_color_depth.translation());
  return depth_image(camera, [&](int u, int v) {
    return distance / normal.dot(camera.color.unproject({u, v}));
  });
}

double largest_distance_from_wall(const PointCloud& cloud) {
  double largest = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    largest = std::max(largest, std::abs(kNormal.dot(cloud.position(i)) - kDistance));
  }
  return largest;
}

class DepthDelay : public testing::Test {
 protected:
  DepthDelay() {
    options_.min_gradient = 2;
    options_.min_depth = 0.3;
    options_.max_depth = 6;
    options_.max_depth_step = 0.05;
  }

  Camera camera_ = small_camera();
  SelectionOptions options_;
  RgbdFrame frame_ = noise_frame(camera_, 1);
};

// The wall's depth changes by at most 0.18 * 1.5 m / 262 px = 1 mm from pixel to pixel, and depth
// is looked up at the nearest one, up to 0.7 px away; half a depth unit is 0.1 mm.
constexpr double kTolerance = 1e-3;

TEST_F(DepthDelay, ThePointsLieOnTheWallForTheRightMotion) {
  // Motions of a hand in 17 ms: 1 m/s and 1.5 rad/s.
  for (const SE3& T : {motion(0, 0, 0.017, 0, 0, 0), motion(0, 0, 0, 0.025, -0.02, 0),
                       motion(0.01, -0.01, 0.015, 0.02, 0.015, -0.02)}) {
    frame_.depth = wall_from(camera_, T);
    const PointCloud right = select_points(frame_, camera_, 2000, options_, T);
    ASSERT_GT(right.size(), 1500U);
    EXPECT_LT(largest_distance_from_wall(right), kTolerance);
    const PointCloud uncompensated = select_points(frame_, camera_, 2000, options_);
    EXPECT_GT(largest_distance_from_wall(uncompensated), 5 * kTolerance);
  }
}

TEST_F(DepthDelay, ThePointsStayOnTheRaysOfTheirPixels) {
  const SE3 T = motion(0.01, -0.01, 0.015, 0.02, 0.015, -0.02);
  frame_.depth = wall_from(camera_, T);
  const PointCloud cloud = select_points(frame_, camera_, 500, options_, T);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Vector3 ray = camera_.color.unproject({cloud.u[i], cloud.v[i]});
    EXPECT_LT((cloud.position(i) - cloud.z[i] * ray).norm(), 3e-7);  // single precision
  }
}

TEST_F(DepthDelay, AMotionOfNothingChangesNothing) {
  frame_.depth = wall_from(camera_, SE3());
  // Too small to move the lookup to another pixel, large enough to take that path.
  const SE3 T = motion(1e-12, 0, 0, 0, 0, 0);
  const PointCloud cloud = select_points(frame_, camera_, 100000, options_, T);
  // Points at the border are missing, because a motion may push them off the image.
  const std::size_t all = select_points(frame_, camera_, 100000, options_).size();
  EXPECT_GT(cloud.size(), all * 95 / 100);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const auto units =
        frame_.depth.at<std::uint16_t>(static_cast<int>(cloud.v[i]), static_cast<int>(cloud.u[i]));
    EXPECT_NEAR(cloud.z[i], units / camera_.depth_scale, 3e-7);  // single precision
  }
}

TEST_F(DepthDelay, PointsThatTheDepthImageDidNotSeeAreLeftOut) {
  // The depth camera stands half of the image's width to the side: 160 of 320 columns.
  const SE3 T = motion(kDistance * 160 / camera_.color.fx, 0, 0, 0, 0, 0);
  frame_.depth = depth_image(camera_, [](int, int) { return kDistance; });
  const PointCloud cloud = select_points(frame_, camera_, 100000, options_, T);
  ASSERT_GT(cloud.size(), 500U);
  for (const float u : cloud.u) EXPECT_GE(u, 160.0F);
}

TEST_F(DepthDelay, AnyMotionIsSafe) {
  std::mt19937 rng(2);
  std::normal_distribution<double> normal;
  for (const double size : {0.03, 0.3, 3.0, 1e3, 1e9}) {
    for (int i = 0; i < 20; ++i) {
      Vector6 xi;
      for (int k = 0; k < 6; ++k) xi[k] = size * normal(rng);
      const PointCloud cloud = select_points(frame_, camera_, 300, options_, SE3::exp(xi));
      EXPECT_LE(cloud.size(), 300U);
      for (std::size_t p = 0; p < cloud.size(); ++p) {
        ASSERT_TRUE(cloud.position(p).allFinite());
      }
    }
  }
}

}  // namespace
}  // namespace cvo_slam
