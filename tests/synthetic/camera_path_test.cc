// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/synthetic/camera_path.h"

#include <array>
#include <cmath>
#include <vector>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "cvo_slam/core/error.h"

namespace cvo_slam::synthetic {
namespace {

const std::vector<Viewpoint> kSquare = {{{1, 0, 1}, {3, 0, 1}},
                                        {{0, 1, 1.2}, {0, 3, 1}},
                                        {{-1, 0, 1}, {-3, 0, 1}},
                                        {{0, -1, 0.8}, {0, -3, 1}}};

CameraPath square(double duration, std::uint32_t seed) {
  return CameraPath({.viewpoints = kSquare, .duration = duration, .tremor = {.seed = seed}});
}

TEST(LookAt, PutsTheTargetOnTheOpticalAxisAndTheSkyUp) {
  const Vector3 position(1, 2, 1.5);
  const Vector3 target(-2, 0.5, 0.7);
  const SE3 T_camera_world = look_at(position, target).inverse();
  const Vector3 seen = T_camera_world * target;
  EXPECT_NEAR(seen.x(), 0, 1e-12);
  EXPECT_NEAR(seen.y(), 0, 1e-12);
  EXPECT_NEAR(seen.z(), (target - position).norm(), 1e-12);
  EXPECT_LT((T_camera_world * Vector3(target + Vector3(0, 0, 0.1))).y(), 0);  // y points down
  EXPECT_NEAR(T_camera_world.rotation().determinant(), 1, 1e-12);
}

TEST(CameraPath, ClosesItsLoopToTheLastBitOfRounding) {
  const CameraPath path = square(7.5, 4);
  for (const double t : {0.0, 1.3, 7.4}) {
    const SE3 difference = path.T_world_camera(t).inverse() * path.T_world_camera(t + 7.5);
    EXPECT_LT(difference.log().norm(), 1e-12) << t;
  }
}

// Third differences of a function with a continuous second derivative shrink with the step cubed
// times the (bounded) third derivative; a jump of the acceleration by a would leave a * step^2.
TEST(CameraPath, HasNoJumpInItsAcceleration) {
  constexpr double kStep = 1e-3;  // [s]
  // Bound of the third derivative: the spline's is at most 8 |control points| / (knot spacing)^3 <
  // 8 * 1.5 / 1.5^3 = 3.6 m/s^3 here; the tremor adds sum over waves of amplitude * omega^3, below
  // 3 axes * 4 waves * 0.003 / f^2 * (2 pi f)^3 < 36 m/s^3. Targets turn about twice as fast.
  constexpr double kBound = 60;
  const CameraPath path = square(6.0, 2);
  for (int i = 0; i < 6100; ++i) {  // beyond the seam at 6 s
    std::array<SE3, 4> pose;
    for (int k = 0; k < 4; ++k) {
      pose[static_cast<std::size_t>(k)] = path.T_world_camera((i + k) * kStep);
    }
    const Vector3 jerk = pose[3].translation() - 3 * pose[2].translation() +
                         3 * pose[1].translation() - pose[0].translation();
    ASSERT_LT(jerk.norm(), kBound * kStep * kStep * kStep) << "at " << i * kStep << " s";
    const Vector3 turn_jerk = so3_log(pose[2].rotation().transpose() * pose[3].rotation()) -
                              2 * so3_log(pose[1].rotation().transpose() * pose[2].rotation()) +
                              so3_log(pose[0].rotation().transpose() * pose[1].rotation());
    ASSERT_LT(turn_jerk.norm(), 2 * kBound * kStep * kStep * kStep) << "at " << i * kStep << " s";
  }
}

TEST(CameraPath, TremorDependsOnTheSeed) {
  const CameraPath one = square(6.0, 1);
  const CameraPath same = square(6.0, 1);
  const CameraPath other = square(6.0, 2);
  EXPECT_EQ(one.T_world_camera(1).matrix(), same.T_world_camera(1).matrix());
  EXPECT_NE(one.T_world_camera(1).matrix(), other.T_world_camera(1).matrix());
}

TEST(CameraPath, RefusesTooFewViewpointsAndNoDuration) {
  EXPECT_THROW(CameraPath({.viewpoints = {kSquare[0], kSquare[1], kSquare[2]}}), OptionError);
  EXPECT_THROW(square(0, 1), OptionError);
  EXPECT_THROW(square(std::nan(""), 1), OptionError);
  EXPECT_THROW(CameraPath({.viewpoints = kSquare, .speed = -1}), OptionError);
}

}  // namespace
}  // namespace cvo_slam::synthetic
