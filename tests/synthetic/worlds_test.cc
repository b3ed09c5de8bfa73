// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Properties of all built-in worlds.
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "cvo_slam/synthetic/rendering.h"
#include "cvo_slam/synthetic/sequence.h"
#include "cvo_slam/synthetic/world.h"
#include "cvo_slam/tests/synthetic/reprojection.h"

namespace cvo_slam::synthetic {
namespace {

const PinholeCamera kCamera = synthetic_camera(96, 72).color;

/// A world and some frames along its path.
struct FilmedWorld {
  explicit FilmedWorld(const std::string& name) : world(make_world(name)) {
    constexpr int kFrames = 6;
    for (int i = 0; i < kFrames; ++i) {
      seconds.push_back((i + 0.3) / kFrames * world.path.duration());
      frames.push_back(render(world.scene, kCamera, world.path.T_world_camera(seconds.back())));
    }
  }

  World world;
  std::vector<double> seconds;
  std::vector<Rendering> frames;
};

/// Returns a world, which is made and rendered once for all tests.
const FilmedWorld& filmed(const std::string& name) {
  static std::map<std::string, FilmedWorld> worlds;
  return worlds.try_emplace(name, name).first->second;
}

class Worlds : public ::testing::TestWithParam<std::string> {
 protected:
  const FilmedWorld& film_ = filmed(GetParam());
  const World& world_ = film_.world;
};

TEST_P(Worlds, CameraKeepsClearOfAllSurfaces) {
  for (double t = 0; t < world_.path.duration(); t += 0.02) {
    ASSERT_GT(clearance(world_.scene, world_.path.T_world_camera(t).translation()), 0.25) << t;
  }
}

TEST_P(Worlds, FramesReprojectIntoEachOther) {
  for (std::size_t i = 0; i < film_.frames.size(); ++i) {
    const double start = film_.seconds[i];
    const Rendering& frame = film_.frames[i];
    const SE3 T_world_a = world_.path.T_world_camera(start);
    const SE3 T_world_b = world_.path.T_world_camera(start + 0.3);
    const auto result = reproject(frame, render(world_.scene, kCamera, T_world_b),
                                  T_world_b.inverse() * T_world_a, kCamera);
    // 0.3 s turn the camera by at most about 15 of its 63 degrees.
    ASSERT_GT(result.compared, static_cast<std::size_t>(96 * 72 / 2)) << start;
    EXPECT_LT(result.occluded, result.compared / 10) << start;
    // On a smooth surface the depth is between those of neighbouring pixels. The rest is at rims,
    // of which an office has many in so small an image.
    EXPECT_LT(quantile(result.depth_errors, 0.93), 1e-3) << start;
    // Lambert's law: the colour stays. Rounding to a pixel costs at most half of the difference to
    // the neighbours, in both directions.
    EXPECT_LT(quantile(result.color_errors, 0.5), neighbor_difference(frame) + 0.5) << start;
  }
}

TEST_P(Worlds, FillTheImageAndAreWellExposed) {
  for (std::size_t i = 0; i < film_.frames.size(); ++i) {
    const Rendering& frame = film_.frames[i];
    const double t = film_.seconds[i];
    EXPECT_EQ(cv::countNonZero(frame.depth <= 0.1), 0) << "a hole in the world, at " << t;
    // No surface is far away, also if the floor reaches to the horizon.
    EXPECT_EQ(cv::countNonZero(frame.depth > 25), 0) << t;
    cv::Mat grey;
    cv::cvtColor(frame.color, grey, cv::COLOR_BGR2GRAY);
    const double mean = cv::mean(grey)[0];
    EXPECT_GT(mean, 50) << t;
    EXPECT_LT(mean, 200) << t;
  }
}

TEST_P(Worlds, TheSameSeedGivesTheSameWorldAndAnotherOtherTextures) {
  EXPECT_EQ(world_text(world_), world_text(make_world(GetParam())));
  const World other = make_world(GetParam(), {.seed = 2});
  EXPECT_NE(other.scene.primitives[0].texture.seed, world_.scene.primitives[0].texture.seed);
  EXPECT_NE(other.path.plan().tremor.seed, world_.path.plan().tremor.seed);
  ASSERT_EQ(other.path.plan().viewpoints.size(), world_.path.plan().viewpoints.size());
  EXPECT_EQ(other.path.plan().viewpoints[3].position, world_.path.plan().viewpoints[3].position);
}

INSTANTIATE_TEST_SUITE_P(BuiltIn, Worlds, ::testing::ValuesIn(world_names()),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace cvo_slam::synthetic
