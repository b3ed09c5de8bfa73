// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "cvo_slam/synthetic/rendering.h"
#include "cvo_slam/synthetic/sequence.h"
#include "cvo_slam/synthetic/world.h"

namespace cvo_slam::synthetic {
namespace {

constexpr double kStep = 0.02;  // [s]

TEST(House, TheLoopIsLongAndItsStartIsSeenAgain) {
  const World house = make_world("house");
  EXPECT_NEAR(house.path.duration(), 60, 6);
  // The early pose that is nearest to the end, and the length of the path between the two.
  const double end = house.path.duration() - 2;
  const SE3 last = house.path.T_world_camera(end);
  double nearest = 1e9;
  double start = 0;
  for (double t = 0; t < 15; t += kStep) {
    const double away = (house.path.T_world_camera(t).translation() - last.translation()).norm();
    if (away < nearest) {
      nearest = away;
      start = t;
    }
  }
  EXPECT_LT(nearest, 0.3);
  EXPECT_GT(start, 1);  // it went beyond its start
  EXPECT_LT((house.path.T_world_camera(start).inverse() * last).angle(), 0.5);
  double loop = 0;
  for (double t = start; t < end; t += kStep) {
    loop += (house.path.T_world_camera(t + kStep).translation() -
             house.path.T_world_camera(t).translation())
                .norm();
  }
  EXPECT_GT(loop, 40);
}

TEST(House, OneWalksAtAWalkersPace) {
  const World house = make_world("house");
  for (double t = 0; t < house.path.duration(); t += 0.1) {
    const SE3 motion = house.path.T_world_camera(t).inverse() * house.path.T_world_camera(t + 0.1);
    ASSERT_LT(motion.translation().norm(), 1.2 * 0.1) << t;
    ASSERT_LT(motion.angle(), 0.1 * 90 * std::numbers::pi / 180) << t;  // 90 deg/s in a turn
  }
}

TEST(House, TheCorridorsAreAmbiguousButNotTheSame) {
  const World house = make_world("house");
  const PinholeCamera camera = synthetic_camera(96, 72).color;
  const auto grey_from = [&](const Vector3& position, const Vector3& target) {
    cv::Mat grey;
    cv::cvtColor(render(house.scene, camera, look_at(position, target)).color, grey,
                 cv::COLOR_BGR2GRAY);
    return grey;
  };
  const cv::Mat north = grey_from({-2, 3.2, 1.45}, {2, 3.2, 1.2});
  const cv::Mat south = grey_from({2, -3.2, 1.45}, {-2, -3.2, 1.2});
  cv::Mat correlation;
  cv::matchTemplate(north, south, correlation, cv::TM_CCOEFF_NORMED);
  // They differ in the grain of walls and wood, in prints, and in the room at the end.
  EXPECT_GT(correlation.at<float>(0, 0), 0.9F);
  EXPECT_GT(cv::norm(north, south, cv::NORM_INF), 10);
}

}  // namespace
}  // namespace cvo_slam::synthetic
