// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "cvo_slam/synthetic/rendering.h"
#include "cvo_slam/synthetic/sequence.h"
#include "cvo_slam/synthetic/world.h"

namespace cvo_slam::synthetic {
namespace {

bool same_bytes(const cv::Mat& a, const cv::Mat& b) {
  const std::size_t bytes = a.total() * a.elemSize();
  return a.size() == b.size() && a.type() == b.type() && std::equal(a.data, a.data + bytes, b.data);
}

class WorldFile : public ::testing::TestWithParam<std::string> {};

TEST_P(WorldFile, GivesTheVeryWorldThatWasWritten) {
  const World world = make_world(GetParam());
  const std::string text = world_text(world);
  const World again = parse_world(text, "again.yaml", 99);  // nothing is left to the seed
  EXPECT_EQ(world_text(again), text);
  ASSERT_EQ(again.scene.primitives.size(), world.scene.primitives.size());
  EXPECT_EQ(again.path.duration(), world.path.duration());
  const PinholeCamera camera = synthetic_camera(64, 48).color;
  for (const double t : {0.4, 7.7}) {
    const SE3 T_world_camera = world.path.T_world_camera(t);
    ASSERT_EQ(again.path.T_world_camera(t).matrix(), T_world_camera.matrix()) << t;
    const Rendering one = render(world.scene, camera, T_world_camera);
    const Rendering other = render(again.scene, camera, T_world_camera);
    EXPECT_TRUE(same_bytes(one.color, other.color)) << t;
    EXPECT_TRUE(same_bytes(one.depth, other.depth)) << t;
  }
}

INSTANTIATE_TEST_SUITE_P(BuiltIn, WorldFile, ::testing::ValuesIn(world_names()),
                         [](const auto& test) { return test.param; });

constexpr const char* kOwnWorld = R"(
ambient: 0.6
lights:
  - {position: [0, 0, 2], power: 1.5}
materials:
  red_wood: {like: oak, base: [0.8, 0.2, 0.1]}
shapes:
  - box: [1, 2, 0.4]
    on: [0, 3, 0.5]
    yaw: 0.3
    material: red_wood
  - sheet: [2, 1]
    at: [0, 5, 1]
    facing: [0, 1, 0]
    material: {pattern: collage, scale: 0.3, contrast: 0}
    seed: 7
  - cylinder: [0.1, 0.2]
    on: [3, 0, 0]
    material: poster
    swing: {amplitude: [0.5, 0, 0], period: 4}
  - sphere: 0.3
    at: [3, 3, 1]
    rotation: [[0, -1, 0], [1, 0, 0], [0, 0, 1]]
    material: {like: red_wood, quarter_turn: true}
anchor: {position: [0, 0, 1], target: [0, 3, 1], pan: 0.5}
path:
  duration: 8
  closed: false
  viewpoints:
    - {position: [0, 0, 1], target: [0, 3, 1]}
    - {position: [0.2, 0, 1], target: [0, 3, 1]}
    - {position: [0.4, 0, 1], target: [0, 3, 1]}
    - {position: [0.6, 0, 1], target: [0, 3, 1]}
)";

TEST(OwnWorld, IsReadAsDocumented) {
  const World world = parse_world(kOwnWorld, "own.yaml");
  const auto& shapes = world.scene.primitives;
  ASSERT_EQ(shapes.size(), 4U);
  EXPECT_EQ(world.scene.ambient, 0.6);
  EXPECT_EQ(world.scene.lights.at(0).power, 1.5);
  EXPECT_LT((shapes[0].T_world_shape.translation() - Vector3(0, 3, 0.7)).norm(), 1e-12)
      << "'on' is the foot";
  EXPECT_EQ(shapes[0].T_world_shape.rotation(), so3_exp({0, 0, 0.3}));
  EXPECT_EQ(shapes[0].texture.pattern, Pattern::kWood);
  EXPECT_EQ(shapes[0].texture.base[0], 0.8);
  EXPECT_EQ(shapes[1].texture.pattern, Pattern::kCollage);
  EXPECT_EQ(shapes[1].texture.seed, 7U);
  EXPECT_EQ(shapes[1].T_world_shape.rotation().col(2), Vector3::UnitY());
  ASSERT_TRUE(shapes[2].swing);
  EXPECT_EQ(shapes[2].swing->period, 4);
  EXPECT_TRUE(shapes[3].texture.quarter_turn);
  EXPECT_EQ(shapes[3].T_world_shape.rotation()(0, 1), -1);
  EXPECT_EQ(world.anchor.pan, 0.5);
  EXPECT_FALSE(world.path.plan().closed);
}

TEST(OwnWorld, GetsItsMissingSeedsFromTheGivenOne) {
  const World one = parse_world(kOwnWorld, "own.yaml", 1);
  const World same = parse_world(kOwnWorld, "own.yaml", 1);
  const World other = parse_world(kOwnWorld, "own.yaml", 2);
  EXPECT_EQ(world_text(one), world_text(same));
  EXPECT_NE(one.scene.primitives[0].texture.seed, other.scene.primitives[0].texture.seed);
  EXPECT_EQ(one.scene.primitives[1].texture.seed, other.scene.primitives[1].texture.seed);
  EXPECT_NE(one.path.plan().tremor.seed, other.path.plan().tremor.seed);
}

TEST(OwnWorld, SurvivesBeingWrittenWithRotationAndSwing) {
  const std::string text = world_text(parse_world(kOwnWorld, "own.yaml"));
  EXPECT_EQ(world_text(parse_world(text, "again.yaml")), text);
}

TEST(OwnWorld, AnOpenPathStartsAndEndsAtRestAtItsEndPoints) {
  const World world = parse_world(kOwnWorld, "own.yaml");
  PathPlan plan = world.path.plan();
  plan.tremor = {.translation = 0, .rotation = 0, .seed = 0};
  const CameraPath path{plan};
  EXPECT_LT((path.T_world_camera(0).translation() - Vector3(0, 0, 1)).norm(), 1e-12);
  EXPECT_LT((path.T_world_camera(8).translation() - Vector3(0.6, 0, 1)).norm(), 1e-12);
  EXPECT_LT((path.T_world_camera(9).translation() - Vector3(0.6, 0, 1)).norm(), 1e-12);
  const Vector3 step = path.T_world_camera(1e-3).translation() - Vector3(0, 0, 1);
  EXPECT_LT(step.norm(), 1e-9);
}

}  // namespace
}  // namespace cvo_slam::synthetic
