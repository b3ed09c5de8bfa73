// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The planes around points, and the noise that they show.
#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "cvo_slam/frontend/point_selection.h"
#include "cvo_slam/tests/frontend/test_clouds.h"
#include "cvo_slam/tests/frontend/test_frames.h"

namespace cvo_slam {
namespace {

const Vector3 kWallNormal = Vector3(0.3, -0.2, 1).normalized();
constexpr int kPoints = 400;

/// A camera whose depth unit is 0.01 mm at a scale of 1e5, so that rounding is no noise; it sees
/// 0.6 m far.
Camera fine_camera() {
  Camera camera = small_camera();
  camera.depth_scale = 1e5;
  return camera;
}

/// Returns the depth of a slanted wall half a metre away with Gaussian noise of a standard
/// deviation [m].
cv::Mat wall(const Camera& camera, double noise) {
  std::mt19937 rng(7);
  std::normal_distribution<double> normal(0, 1);
  return depth_image(camera, [&](int u, int v) {
    return 0.5 / kWallNormal.dot(camera.color.unproject({u, v})) + noise * normal(rng);
  });
}

PointCloud points_of(const Camera& camera, const cv::Mat& depth, const SE3& T_color_depth = {}) {
  RgbdFrame frame;
  frame.color = noise_image(camera, 3);
  frame.depth = depth;
  SelectionOptions options;
  options.min_depth = 0.2;
  return select_points(frame, camera, kPoints, options, T_color_depth);
}

double largest_angle_from(const Vector3& normal, const PointCloud& cloud) {
  double largest = 0;
  for (const SurfacePatch& patch : cloud.surfaces) {
    const Vector3 n = patch.normal.cast<double>();
    if (n.norm() > 0) largest = std::max(largest, n.cross(normal).norm() / n.norm());
  }
  return largest;
}

TEST(SurfaceFit, FindsTheNormalOfAWall) {
  const Camera camera = fine_camera();
  const PointCloud cloud = points_of(camera, wall(camera, 0));
  ASSERT_EQ(cloud.surfaces.size(), cloud.size());
  ASSERT_GT(cloud.size(), 300U);
  // Rounding to 0.01 mm over a patch of 6 px (11 mm) tilts it by about a milliradian.
  EXPECT_LT(largest_angle_from(kWallNormal, cloud), 3e-3);
  EXPECT_LT(cloud.surface_noise, 3e-5F);  // rounding: 3e-6 m at half a metre
  for (const SurfacePatch& patch : cloud.surfaces) EXPECT_LT(patch.roughness, 1e-5F);
}

TEST(SurfaceFit, TurnsTheNormalIntoTheFrameOfTheColourImage) {
  const Camera camera = fine_camera();
  const SE3 T_color_depth = motion(0.002, 0, 0, 0.03, -0.02, 0.01);
  const PointCloud cloud = points_of(camera, wall(camera, 0), T_color_depth);
  ASSERT_GT(cloud.size(), 300U);
  EXPECT_LT(largest_angle_from(T_color_depth.rotation() * kWallNormal, cloud), 3e-3);
}

TEST(SurfaceFit, MeasuresTheNoise) {
  const Camera camera = fine_camera();
  constexpr double kNoise = 1e-4;  // at half a metre: 0.4 mm/m^2
  const PointCloud cloud = points_of(camera, wall(camera, kNoise));
  // The depths of the wall are 0.4 to 0.7 m, and the lower quartile of 49 samples' deviations is
  // some 7 % below the mean.
  EXPECT_GT(cloud.surface_noise, 1.5e-4F);
  EXPECT_LT(cloud.surface_noise, 4.5e-4F);
  double roughness = 0;
  for (const SurfacePatch& patch : cloud.surfaces) roughness += patch.roughness;
  // Depth noise counts by its part along the normal, at least 0.8 of it here.
  EXPECT_NEAR(roughness / static_cast<double>(cloud.size()), 0.9 * kNoise, 0.15 * kNoise);
}

TEST(SurfaceFit, LeavesSurfacesOutWhereTheyAreAsNoisyAsAKinects) {
  const Camera camera = fine_camera();
  const PointCloud cloud = points_of(camera, wall(camera, 6e-4));  // 2.4 mm/m^2
  EXPECT_GT(cloud.surface_noise, 1e-3F);
  EXPECT_TRUE(cloud.surfaces.empty());
}

TEST(SurfaceFit, NoiseAlongTheRaysFallsWithTheNoiseThatIsSeen) {
  const Camera camera = fine_camera();
  const PointCloud clean = points_of(camera, wall(camera, 0));
  const PointCloud noisy = points_of(camera, wall(camera, 6e-4));
  ASSERT_EQ(clean.ray_noise.size(), clean.size());
  for (std::size_t i = 0; i < clean.size(); ++i) EXPECT_LT(clean.ray_noise[i], 2e-4F);
  for (std::size_t i = 0; i < noisy.size(); ++i) {
    const double z = noisy.z[i];
    const double expected = camera.noise.sigma_z(z) * noisy.position(i).norm() / z;
    EXPECT_NEAR(noisy.ray_noise[i], expected, 1e-6);
  }
}

TEST(SurfaceFit, AnEdgeIsNoPlane) {
  // Two walls that meet at a right angle, 0.5 m away, in the middle of the image.
  const Camera camera = fine_camera();
  const cv::Mat depth = depth_image(camera, [&](int u, int v) {
    const Vector3 ray = camera.color.unproject({u, v});
    return 0.5 / (1 + std::abs(ray.x()));
  });
  const PointCloud cloud = points_of(camera, depth);
  ASSERT_EQ(cloud.surfaces.size(), cloud.size());
  const double middle = 0.5 * (camera.color.width - 1);
  double at_edge = 0;
  double elsewhere = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const double distance = std::abs(static_cast<double>(cloud.u[i]) - middle);
    const double roughness = cloud.surfaces[i].roughness;
    if (distance < 1) at_edge = std::max(at_edge, roughness);
    if (distance > 8) elsewhere = std::max(elsewhere, roughness);
  }
  EXPECT_LT(elsewhere, 1e-5);
  EXPECT_GT(at_edge, 1e-4);
}

TEST(SurfaceFit, WithoutDepthsAroundThereIsNoPlane) {
  const Camera camera = fine_camera();
  cv::Mat depth = wall(camera, 0);
  // Every other block of 5 px has no depth: of the 49 samples over 7 px, at most 29 have.
  for (int v = 0; v < depth.rows; ++v) {
    for (int u = 0; u < depth.cols; ++u) {
      if ((u / 5 + v / 5) % 2 == 0) depth.at<std::uint16_t>(v, u) = 0;
    }
  }
  const PointCloud cloud = points_of(camera, depth);
  ASSERT_GT(cloud.size(), 20U);
  EXPECT_TRUE(cloud.surfaces.empty());
  EXPECT_TRUE(std::isinf(cloud.surface_noise));
}

}  // namespace
}  // namespace cvo_slam
