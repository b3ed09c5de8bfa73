// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/synthetic/world.h"

namespace cvo_slam::synthetic {
namespace {

using ::testing::HasSubstr;

/// The largest third differences of position [m] and orientation [rad] along a path.
struct Roughness {
  double position = 0;
  double orientation = 0;
};

Roughness roughness(const CameraPath& path, double step) {
  Roughness largest;
  const auto turn = [](const SE3& a, const SE3& b) -> Vector3 {
    return so3_log(a.rotation().transpose() * b.rotation());
  };
  std::array<SE3, 4> pose;
  for (double t = 0; t < 1.05 * path.duration(); t += step) {  // beyond the seam, or the end
    std::rotate(pose.begin(), pose.begin() + 1, pose.end());
    pose[3] = path.T_world_camera(t);
    if (t < 3 * step) continue;
    const Vector3 jerk = pose[3].translation() - 3 * pose[2].translation() +
                         3 * pose[1].translation() - pose[0].translation();
    const Vector3 turn_jerk =
        turn(pose[2], pose[3]) - 2 * turn(pose[1], pose[2]) + turn(pose[0], pose[1]);
    largest.position = std::max(largest.position, jerk.norm());
    largest.orientation = std::max(largest.orientation, turn_jerk.norm());
  }
  return largest;
}

/// Third differences of a function with a continuous second derivative shrink with the cube of the
/// step: to an eighth at half the step. A jump of the acceleration would leave a quarter, one of
/// the velocity a half. A path that does not move has rounding errors only.
void expect_smooth(const CameraPath& path) {
  constexpr double kStep = 0.004;  // [s]; ten steps in the fastest tremor's radian
  constexpr double kRounding = 1e-12;
  const Roughness coarse = roughness(path, kStep);
  const Roughness fine = roughness(path, 0.5 * kStep);
  EXPECT_LT(fine.position, coarse.position / 6 + kRounding);
  EXPECT_LT(fine.orientation, coarse.orientation / 6 + kRounding);
}

class PathStyles : public ::testing::TestWithParam<std::string> {};

TEST_P(PathStyles, TheWorldsOwnPathIsSmoothToTheSecondDerivative) {
  expect_smooth(make_world(GetParam()).path);
}

TEST_P(PathStyles, AllStylesAreSmoothAndKeepClear) {
  for (const auto& [name, style] : path_style_names()) {
    SCOPED_TRACE(name);
    if (style == PathStyle::kWalk) continue;  // below
    const World world = make_world(GetParam(), {.style = style});
    expect_smooth(world.path);
    for (double t = 0; t < world.path.duration(); t += 0.05) {
      const Vector3 position = world.path.T_world_camera(t).translation();
      ASSERT_GT(clearance(world.scene, position), 0.25) << t;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(BuiltIn, PathStyles, ::testing::ValuesIn(world_names()),
                         [](const auto& test) { return test.param; });

TEST(PathSeed, WalksNearbyThroughTheSameWorld) {
  const World world = make_world("office");
  const World other = make_world("office", {.path_seed = 7});
  EXPECT_EQ(world.scene.primitives.size(), other.scene.primitives.size());
  EXPECT_EQ(world.path.duration(), other.path.duration());
  double farthest = 0;
  for (double t = 0; t < world.path.duration(); t += 0.5) {
    const Vector3 way =
        world.path.T_world_camera(t).translation() - other.path.T_world_camera(t).translation();
    farthest = std::max(farthest, way.norm());
  }
  EXPECT_GT(farthest, 0.05);
  EXPECT_LT(farthest, 0.2);
  EXPECT_EQ(make_world("office", {.path_seed = 7}).path.T_world_camera(3).translation(),
            other.path.T_world_camera(3).translation());
}

CameraPath office_path(PathStyle style, double speed = 1) {
  return make_world("office", {.style = style, .speed = speed}).path;
}

TEST(PathStyle, WalkLooksAheadWhereThereIsAWayAndIsRefusedElsewhere) {
  for (const char* name : {"room", "office", "house"}) {
    const World world = make_world(name, {.style = PathStyle::kWalk});
    expect_smooth(world.path);
    for (double t = 2; t < world.path.duration() - 3; t += 0.5) {
      const SE3 T_world_camera = world.path.T_world_camera(t);
      const Vector3 step = world.path.T_world_camera(t + 0.3).translation() -
                           world.path.T_world_camera(t).translation();
      // On the tightest round (0.7 m) a view 1.5 m ahead turns 60 degrees into the curve.
      ASSERT_GT(step.normalized().dot(T_world_camera.rotation().col(2)), 0.4) << name << " " << t;
    }
  }
  try {
    static_cast<void>(make_world("structure_texture_near", {.style = PathStyle::kWalk}));
    FAIL() << "no exception";
  } catch (const OptionError& error) {
    EXPECT_THAT(error.what(), HasSubstr("use handheld, orbit"));
  }
}

TEST(PathStyle, RotateTurnsAllAroundOnTheSpot) {
  const CameraPath path = office_path(PathStyle::kRotate);
  const SE3 start = path.T_world_camera(0);
  double largest = 0;
  for (double t = 0; t < path.duration(); t += 0.1) {
    const SE3 motion = start.inverse() * path.T_world_camera(t);
    ASSERT_LT(motion.translation().norm(), 1e-12) << t;
    largest = std::max(largest, motion.angle());
  }
  EXPECT_GT(largest, 3.0);  // it looked back; the pitch of the view is missing to pi
}

TEST(PathStyle, StillDoesNotMoveAtAll) {
  const CameraPath path = office_path(PathStyle::kStill);
  for (const double t : {0.5, 3.3, 9.9}) {
    EXPECT_LT((path.T_world_camera(0).inverse() * path.T_world_camera(t)).log().norm(), 1e-12);
  }
}

TEST(PathStyle, ShakeTurnsFasterThanAHandButStaysInPlace) {
  const CameraPath shake = office_path(PathStyle::kShake);
  const Vector3 anchor = make_world("office").anchor.view.position;
  double fastest = 0;
  for (double t = 0; t < shake.duration(); t += 0.03) {
    const SE3 motion = shake.T_world_camera(t).inverse() * shake.T_world_camera(t + 0.03);
    fastest = std::max(fastest, motion.angle() / 0.03);
    // Four waves an axis of 5 * 3 mm / f^2, f >= 0.5 Hz, and sqrt(3) for the axes.
    ASSERT_LT((shake.T_world_camera(t).translation() - anchor).norm(), 0.2) << t;
  }
  EXPECT_GT(fastest, 1.0);  // [rad/s]; room, by hand, stays below 1.3 with its own turning
}

TEST(PathStyle, OrbitKeepsItsTargetInTheMiddle) {
  const World world = make_world("office", {.style = PathStyle::kOrbit});
  double travelled = 0;
  for (double t = 0; t < world.path.duration(); t += 0.1) {
    const SE3 T_world_camera = world.path.T_world_camera(t);
    const Vector3 seen = T_world_camera.inverse() * world.anchor.view.target;
    // Only the tremor of the hand, below 0.1 rad.
    ASSERT_LT(seen.head<2>().norm(), 0.1 * seen.z()) << t;
    travelled =
        std::max(travelled, (T_world_camera.translation() - world.anchor.view.position).norm());
  }
  EXPECT_GT(travelled, 0.2);
}

TEST(PathStyle, SpeedScalesTime) {
  const CameraPath slow = office_path(PathStyle::kHandheld);
  const CameraPath fast = office_path(PathStyle::kHandheld, 2);
  EXPECT_DOUBLE_EQ(fast.duration(), 0.5 * slow.duration());
  EXPECT_EQ(fast.T_world_camera(1.25).matrix(), slow.T_world_camera(2.5).matrix());
}

TEST(PathStyle, ABadSpeedIsRefused) {
  EXPECT_THROW(static_cast<void>(make_world("room", {.speed = 0})), OptionError);
  EXPECT_THROW(static_cast<void>(make_world("room", {.speed = std::nan("")})), OptionError);
}

}  // namespace
}  // namespace cvo_slam::synthetic
