// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "cvo_slam/frontend/rolling_shutter_internal.h"
#include "cvo_slam/tests/frontend/test_clouds.h"

namespace cvo_slam {
namespace {

TEST(RollingShutter, IsUndone) {
  // Points as rows saw them that were read 10 ms before, at and after the stamp, by a camera with
  // this velocity.
  constexpr double kReadout = 0.026;
  constexpr int kRows = 480;
  Vector6 velocity;
  velocity << 0.3, -0.2, 0.1, 0.5, -1.0, 0.8;
  const PointCloud truth = random_cloud(30, 1);
  PointCloud seen = truth;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    seen.v[i] = static_cast<float>(i * 16);
    const double dt = (static_cast<double>(i * 16) - 239.5) / kRows * kReadout;
    const Vector3 p = SE3::exp(dt * velocity).inverse() * truth.position(i);
    seen.x[i] = static_cast<float>(p.x());
    seen.y[i] = static_cast<float>(p.y());
    seen.z[i] = static_cast<float>(p.z());
  }
  PointCloud undone = seen;
  undo_rolling_shutter(seen, velocity, kReadout, kRows, undone);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    // The second order of 1.4 rad/s in 13 ms: (0.018)^2 / 2 of 2 m.
    EXPECT_LT((undone.position(i) - truth.position(i)).norm(), 4e-4) << i;
  }
  EXPECT_GT((seen.position(0) - truth.position(0)).norm(), 0.01) << "there was something to undo";
}

TEST(RollingShutter, OfACameraAtRestChangesNothing) {
  PointCloud cloud = random_cloud(5, 2);
  const PointCloud seen = cloud;
  undo_rolling_shutter(seen, Vector6::Zero(), 0.03, 480, cloud);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    EXPECT_EQ(cloud.position(i), seen.position(i));
  }
}

}  // namespace
}  // namespace cvo_slam
