// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <random>
#include <string>
#include <tuple>

#include <gtest/gtest.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/slam/compact_cloud_internal.h"

namespace cvo_slam {
namespace {

/// Points from 5 cm to 60 m, as a depth camera sees them.
PointCloud random_cloud(std::size_t count, bool with_surfaces) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> unit(0, 1);
  PointCloud cloud;
  cloud.ray_noise.resize(count);
  cloud.surfaces.resize(with_surfaces ? count : 0);
  cloud.surface_noise = 0.0003F;
  cloud.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    cloud.z[i] = 0.05F * std::pow(1200.0F, unit(random));
    cloud.x[i] = (2 * unit(random) - 1) * cloud.z[i];
    cloud.y[i] = (2 * unit(random) - 1) * cloud.z[i];
    for (std::size_t k = 0; k < 3; ++k) cloud.features[k][i] = std::floor(256 * unit(random));
    for (std::size_t k = 3; k < 5; ++k) cloud.features[k][i] = 200 * unit(random) - 100;
    const Vector3 p = cloud.position(i);
    cloud.ray_noise[i] = static_cast<float>(SensorNoise().sigma_z(p.z()) * p.norm() / p.z());
    if (!with_surfaces || i % 3 == 0) continue;
    cloud.surfaces[i] = {
        Eigen::Vector3f(unit(random) - 0.5F, unit(random) - 0.5F, -unit(random)).normalized(),
        0.0002F + 0.003F * unit(random)};
  }
  return cloud;
}

TEST(CompactCloud, RoundsWhatItKeeps) {
  const PointCloud cloud = random_cloud(2000, true);
  const CompactCloud compact(cloud);
  const PointCloud again = compact.points();
  ASSERT_EQ(again.size(), cloud.size());
  EXPECT_EQ(again.surface_noise, cloud.surface_noise);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    EXPECT_NEAR(again.z[i], cloud.z[i], 0.0001 * cloud.z[i]) << i;
    EXPECT_NEAR(again.x[i] / again.z[i], cloud.x[i] / cloud.z[i], 0.51 / 8192) << i;
    EXPECT_NEAR(again.y[i] / again.z[i], cloud.y[i] / cloud.z[i], 0.51 / 8192) << i;
    EXPECT_LT((compact.position(i) - again.position(i)).norm(), 1e-5 * cloud.z[i]) << i;
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(again.features[k][i], cloud.features[k][i]) << i;
    for (std::size_t k = 3; k < 5; ++k) {
      EXPECT_NEAR(again.features[k][i], cloud.features[k][i], 0.51) << i;
    }
    EXPECT_NEAR(again.ray_noise[i] / cloud.ray_noise[i], 1, 0.001) << i;
    if (cloud.surfaces[i].normal.isZero()) {
      EXPECT_TRUE(again.surfaces[i].normal.isZero()) << i;
      continue;
    }
    EXPECT_GT(again.surfaces[i].normal.dot(cloud.surfaces[i].normal), std::cos(0.02)) << i;
    EXPECT_NEAR(again.surfaces[i].roughness / cloud.surfaces[i].roughness, 1, 0.03) << i;
  }
}

TEST(CompactCloud, TakesElevenBytesAPoint) {
  const CompactCloud compact(random_cloud(1000, false));
  EXPECT_LT(compact.bytes(), 11'100U);
  EXPECT_TRUE(compact.points().surfaces.empty());
}

// Colours are divided by the exposure's gain, and may exceed 255.
TEST(CompactCloud, KeepsBrightColours) {
  PointCloud cloud = random_cloud(100, false);
  for (float& value : cloud.features[1]) value *= 2;
  const PointCloud again = CompactCloud(cloud).points();
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    EXPECT_NEAR(again.features[1][i], cloud.features[1][i], 1.01) << i;
  }
}

TEST(CompactCloud, ItsBytesGiveItBack) {
  for (const bool with_surfaces : {false, true}) {
    const std::string bytes = CompactCloud(random_cloud(300, with_surfaces)).to_bytes();
    EXPECT_EQ(CompactCloud::from_bytes(bytes).to_bytes(), bytes);
    // Rounding what is rounded changes nothing.
    EXPECT_EQ(CompactCloud(CompactCloud::from_bytes(bytes).points()).points().z,
              CompactCloud::from_bytes(bytes).points().z);
  }
  EXPECT_EQ(CompactCloud::from_bytes(CompactCloud(PointCloud()).to_bytes()).size(), 0U);
}

TEST(CompactCloud, DamagedBytesAreErrors) {
  const std::string bytes = CompactCloud(random_cloud(20, true)).to_bytes();
  EXPECT_THROW(std::ignore = CompactCloud::from_bytes(""), DataError);
  EXPECT_THROW(std::ignore = CompactCloud::from_bytes(bytes.substr(0, bytes.size() - 1)),
               DataError);
  EXPECT_THROW(std::ignore = CompactCloud::from_bytes(bytes + "x"), DataError);
  std::string many = bytes;
  many[3] = '\x7f';  // two thousand million points
  EXPECT_THROW(std::ignore = CompactCloud::from_bytes(many), DataError);
}

}  // namespace
}  // namespace cvo_slam
