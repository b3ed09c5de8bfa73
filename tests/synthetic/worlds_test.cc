// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What all built-in worlds promise.
#include <string>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "cvo_slam/synthetic/renderer.h"
#include "cvo_slam/synthetic/sequence.h"
#include "cvo_slam/synthetic/world.h"
#include "cvo_slam/synthetic/world_file.h"
#include "cvo_slam/tests/synthetic/reprojection.h"

namespace cvo_slam::synthetic {
namespace {

class Worlds : public ::testing::TestWithParam<std::string> {
 protected:
  const World world_ = make_world(GetParam());
  const PinholeCamera camera_ = synthetic_camera(96, 72).color;
};

TEST_P(Worlds, CameraKeepsClearOfAllSurfaces) {
  for (double t = 0; t < world_.path.duration(); t += 0.02) {
    ASSERT_GT(clearance(world_.scene, world_.path.T_world_camera(t).translation()), 0.25) << t;
  }
}

TEST_P(Worlds, FramesReprojectIntoEachOther) {
  constexpr int kPairs = 5;
  for (int i = 0; i < kPairs; ++i) {
    const double start = (i + 0.3) / kPairs * world_.path.duration();
    const SE3 T_world_a = world_.path.T_world_camera(start);
    const SE3 T_world_b = world_.path.T_world_camera(start + 0.3);
    const Rendering frame = render(world_.scene, camera_, T_world_a);
    const auto result = reproject(frame, render(world_.scene, camera_, T_world_b),
                                  T_world_b.inverse() * T_world_a, camera_);
    // 0.3 s turn the camera by at most about 15 of its 63 degrees.
    ASSERT_GT(result.compared, static_cast<std::size_t>(96 * 72 / 2)) << start;
    EXPECT_LT(result.occluded, result.compared / 10) << start;
    // Between neighbouring pixels' depths on every smooth surface; the rest sits at rims, of which
    // an office has many in so small an image.
    EXPECT_LT(quantile(result.depth_errors, 0.93), 1e-3) << start;
    // Lambert: colour stays. The rounding to a pixel costs at most half of what it differs from its
    // neighbours by, in both directions.
    EXPECT_LT(quantile(result.color_errors, 0.5), neighbor_difference(frame) + 0.5) << start;
  }
}

TEST_P(Worlds, FillTheImageAndAreWellExposed) {
  constexpr int kViews = 6;
  for (int i = 0; i < kViews; ++i) {
    const double t = i * world_.path.duration() / kViews;
    const Rendering rendering = render(world_.scene, camera_, world_.path.T_world_camera(t));
    EXPECT_EQ(cv::countNonZero(rendering.depth <= 0.1), 0) << "a hole in the world, at " << t;
    // Indoors, also where the floor reaches to the horizon.
    EXPECT_EQ(cv::countNonZero(rendering.depth > 25), 0) << t;
    cv::Mat grey;
    cv::cvtColor(rendering.color, grey, cv::COLOR_BGR2GRAY);
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
