// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/synthetic/sensor.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "cvo_slam/core/error.h"
#include "cvo_slam/synthetic/image_sensors_internal.h"
#include "cvo_slam/synthetic/ray_caster_internal.h"
#include "cvo_slam/synthetic/rendering.h"
#include "cvo_slam/synthetic/sequence.h"
#include "cvo_slam/synthetic/world.h"
#include "cvo_slam/tests/synthetic/plane_scene.h"

namespace cvo_slam::synthetic {
namespace {

const Camera kCamera = synthetic_camera(160, 120);
const CameraMotion kStill = [](double) { return SE3(); };
/// Turns to the right by one radian a second.
const CameraMotion kTurning = [](double t) { return SE3(so3_exp({0, t, 0}), Vector3::Zero()); };

WorldScene wooden_wall() {
  Texture texture;
  texture.pattern = Pattern::kWood;
  texture.contrast = 0.8;
  return sheet_scene(SE3(Matrix3::Identity(), {0, 0, 2}), texture);
}

Sensor sensor_of(const WorldScene& scene, const CameraMotion& motion, const SensorOptions& options,
                 std::uint32_t seed = 1) {
  return {scene, motion, 10, kCamera, options, seed};
}

double mean_difference(const cv::Mat& a, const cv::Mat& b) {
  return cv::norm(a, b, cv::NORM_L1) / static_cast<double>(a.total() * 3);
}

bool equal(const cv::Mat& a, const cv::Mat& b) { return cv::norm(a, b, cv::NORM_INF) == 0; }

/// The ideal images at a time, as a file holds them.
Capture ideal(const WorldScene& scene, const CameraMotion& motion, double seconds) {
  const Rendering rendering = render(scene_at(scene, seconds), kCamera.color, motion(seconds));
  Capture capture;
  rendering.color.convertTo(capture.color, CV_8UC3);
  capture.depth.create(rendering.depth.size(), CV_16UC1);
  std::transform(rendering.depth.begin<double>(), rendering.depth.end<double>(),
                 capture.depth.begin<std::uint16_t>(), [](double depth) {
                   return static_cast<std::uint16_t>(std::round(depth * kCamera.depth_scale));
                 });
  return capture;
}

TEST(Sensor, AnIdealOneShowsWhatTheRendererDoes) {
  const World world = make_world("room");
  const CameraMotion motion = [&](double t) { return world.path.T_world_camera(t); };
  const Sensor sensor = sensor_of(world.scene, motion, {});
  const Capture together = sensor.capture(3, {.color = 0.7, .depth = 0.7});
  const Capture expected = ideal(world.scene, motion, 0.7);
  EXPECT_TRUE(equal(together.color, expected.color));
  EXPECT_TRUE(equal(together.depth, expected.depth));
  const Capture color = sensor.capture(3, {.color = 0.7, .depth = std::nullopt});
  EXPECT_TRUE(equal(color.color, expected.color));
  EXPECT_TRUE(color.depth.empty());
  const Capture depth = sensor.capture(3, {.color = std::nullopt, .depth = 0.7});
  EXPECT_TRUE(depth.color.empty());
  EXPECT_TRUE(equal(depth.depth, expected.depth));
}

TEST(Sensor, EachImageShowsItsOwnInstant) {
  const Sensor sensor = sensor_of(plane_at(2, 0.5), kTurning, {});
  const Capture capture = sensor.capture(0, {.color = 0.0, .depth = 0.01});
  EXPECT_TRUE(equal(capture.depth, ideal(plane_at(2, 0.5), kTurning, 0.01).depth));
  EXPECT_FALSE(equal(capture.depth, ideal(plane_at(2, 0.5), kTurning, 0).depth));
}

TEST(Sensor, ABlurredImageIsTheMeanOfInstants) {
  SensorOptions options;
  options.exposure.time = 0.03;
  const Sensor sensor = sensor_of(wooden_wall(), kTurning, options);
  const int instants = sensor.instants(0.1);
  // One radian a second is 131 px/s in the middle and 183 px/s at the rim, 31.5 deg off: 4 to 5.5
  // px in 0.03 s, in steps of 1.5 px.
  EXPECT_EQ(instants, 4);
  cv::Mat mean = cv::Mat::zeros(120, 160, CV_32FC3);
  for (int i = 0; i < instants; ++i) {
    const double t = 0.1 + 0.03 * ((i + 0.5) / instants - 0.5);
    mean += render(wooden_wall(), kCamera.color, kTurning(t)).color / instants;
  }
  mean.convertTo(mean, CV_8UC3);
  const cv::Mat blurred = sensor.capture(0, {.color = 0.1, .depth = std::nullopt}).color;
  const cv::Mat sharp = ideal(wooden_wall(), kTurning, 0.1).color;
  EXPECT_LT(mean_difference(blurred, mean), 0.01);  // a few pixels are rounded the other way
  EXPECT_GT(mean_difference(blurred, sharp), 1);
}

TEST(Sensor, WhatStandsStillIsNotBlurred) {
  SensorOptions options;
  options.exposure.time = 0.03;
  const Sensor still = sensor_of(wooden_wall(), kStill, options);
  EXPECT_EQ(still.instants(0.1), 1);
  EXPECT_TRUE(equal(still.capture(0, {.color = 0.1, .depth = 0.1}).color,
                    ideal(wooden_wall(), kStill, 0.1).color));
  EXPECT_EQ(sensor_of(wooden_wall(), kTurning, {}).instants(0.1), 1);
}

TEST(Sensor, MovingThingsAreBlurredBeforeAStillCamera) {
  WorldScene scene = wooden_wall();
  // At a metre and a metre a second: 131 px/s, 3.9 px in the exposure.
  scene.primitives.push_back({Box{{0.5, 0.5, 0.5}}, SE3(Matrix3::Identity(), {0, 0, 1.25}),
                              plain(0.9), Swing{{0.5, 0, 0}, std::numbers::pi, 0}});
  SensorOptions options;
  options.exposure.time = 0.03;
  EXPECT_EQ(sensor_of(scene, kStill, options).instants(0), 3);
}

TEST(Sensor, UnderARollingShutterEachRowHasItsOwnPose) {
  SensorOptions options;
  options.exposure.readout = 0.03;
  const World world = make_world("room");
  WorldScene scene = world.scene;
  scene.primitives[0].swing = Swing{{0, 0, 0.01}, 1, 0};  // the floor, that things may move too
  const CameraMotion motion = [&](double t) { return world.path.T_world_camera(t); };
  const Sensor sensor = sensor_of(scene, motion, options);
  const Capture capture = sensor.capture(0, {.color = 2.0, .depth = 2.0});
  for (const int y : {0, 1, 60, 97, 119}) {
    const Capture expected = ideal(scene, motion, 2.0 + 0.03 * (y / 119.0 - 0.5));
    EXPECT_TRUE(equal(capture.depth.row(y), expected.depth.row(y))) << y;
    // Rims are found with the rows above and below, which are displaced: few pixels differ.
    EXPECT_LT(mean_difference(capture.color.row(y), expected.color.row(y)), 0.3) << y;
  }
  EXPECT_FALSE(equal(capture.depth.row(0), ideal(scene, motion, 2.0).depth.row(0)));
}

TEST(Sensor, ExposureChangesTheBrightness) {
  SensorOptions options;
  options.exposure.jump = 0.3;
  options.exposure.jump_interval = 1;
  const Sensor sensor = sensor_of(plane_at(2, 0, 0.4), kStill, options);
  std::vector<double> levels;
  for (int i = 0; i < 10; ++i) {
    const auto color = sensor.capture(0, {.color = i + 0.0, .depth = std::nullopt}).color;
    levels.push_back(cv::mean(color)[0]);
  }
  const auto [low, high] = std::minmax_element(levels.begin(), levels.end());
  EXPECT_GT(*high / *low, 1.3);  // ten levels of a deviation of 0.3 span about three of them
}

TEST(Sensor, AnyFrameCanBeTakenAlone) {
  const World world = make_world("room");
  const CameraMotion motion = [&](double t) { return world.path.T_world_camera(t); };
  const SensorOptions options = sensor_preset("kinect");
  const Exposure now{.color = 0.5, .depth = 0.5};
  const Capture first = sensor_of(world.scene, motion, options).capture(7, now);
  const Sensor sensor = sensor_of(world.scene, motion, options);
  const Capture other_frame = sensor.capture(8, now);
  const Capture again = sensor.capture(7, now);
  EXPECT_TRUE(equal(first.color, again.color) && equal(first.depth, again.depth));
  EXPECT_FALSE(equal(first.color, other_frame.color) || equal(first.depth, other_frame.depth));
  const Capture other_seed = sensor_of(world.scene, motion, options, 2).capture(7, now);
  EXPECT_FALSE(equal(first.color, other_seed.color) || equal(first.depth, other_seed.depth));
}

TEST(Sensor, NoisyFramesReprojectIntoEachOtherToTheNoiseAskedFor) {
  const World world = make_world("room");
  const CameraMotion motion = [&](double t) { return world.path.T_world_camera(t); };
  SensorOptions options;
  options.depth.axial = 1;
  const Sensor sensor = sensor_of(world.scene, motion, options);
  for (const double start : {0.0, 5.0}) {
    const cv::Mat depth = sensor.capture(0, {.color = std::nullopt, .depth = start}).depth;
    const RayCaster other(world.scene, kCamera.color, motion(start + 0.2));
    const SE3 T_other_camera = motion(start + 0.2).inverse() * motion(start);
    std::vector<double> errors;  // in standard deviations of a surface seen at right angles
    for (int y = 0; y < 120; ++y) {
      for (int x = 0; x < 160; ++x) {
        const double z = depth.at<std::uint16_t>(y, x) / kCamera.depth_scale;
        const Vector3 point = T_other_camera * (z * kCamera.color.unproject({x, y}));
        const Eigen::Vector2d pixel = kCamera.color.project(point);
        if (!kCamera.color.contains(pixel)) continue;
        const double truth = other.look(pixel.x(), pixel.y()).depth;
        errors.push_back(std::abs(point.z() - truth) / kinect_axial_noise(truth, 0));
      }
    }
    ASSERT_GT(errors.size(), 10000U);
    const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
    std::nth_element(errors.begin(), middle, errors.end());
    // The median of a normal distribution's absolute value; a tenth for the angles.
    EXPECT_NEAR(*middle, 0.6745, 0.07) << start;
  }
}

TEST(Sensor, MovingObjectsSwingThroughTheViewClearOfTheCamera) {
  const World world = make_world("room");
  const CameraMotion motion = [&](double t) { return world.path.T_world_camera(t); };
  SensorOptions options;
  options.objects = {.count = 4, .size = 0.3, .speed = 0.6};
  std::vector<cv::Mat> without_objects;
  for (double t = 0; t < 10; t += 0.5) {
    const Sensor sensor = sensor_of(world.scene, motion, {});
    without_objects.push_back(sensor.capture(0, {.color = std::nullopt, .depth = t}).depth);
  }
  for (const std::uint32_t seed : {1U, 2U, 3U}) {
    const Sensor sensor = sensor_of(world.scene, motion, options, seed);
    ASSERT_EQ(sensor.scene().primitives.size(), world.scene.primitives.size() + 4);
    EXPECT_NO_THROW(check(sensor.scene()));
    int seen = 0;
    for (std::size_t i = 0; i < without_objects.size(); ++i) {
      const double t = 0.5 * static_cast<double>(i);
      const WorldScene now = scene_at(sensor.scene(), t);
      ASSERT_GT(clearance(now, motion(t).translation()), 0.2) << t;
      const Capture capture = sensor.capture(0, {.color = std::nullopt, .depth = t});
      seen += equal(capture.depth, without_objects[i]) ? 0 : 1;
    }
    EXPECT_GE(seen, 4) << seed;  // of 20
    const Swing& swing = sensor.scene().primitives.back().swing.value();
    EXPECT_NEAR(swing.amplitude.norm() * 2 * std::numbers::pi / swing.period, 0.6, 1e-9);
  }
}

TEST(Sensor, BoxesWithoutAPlaceAreRefused) {
  SensorOptions options;
  options.objects = {.count = 1, .size = 10, .speed = 0.5};
  EXPECT_THROW(sensor_of(plane_at(0.2, 0), kStill, options), OptionError);
}

TEST(Sensor, ACameraWithDistortionIsRefused) {
  Camera camera = kCamera;
  camera.color.distortion[0] = 0.1;
  EXPECT_THROW(Sensor(plane_at(2, 0), kStill, 1, camera, {}, 1), OptionError);
}

}  // namespace
}  // namespace cvo_slam::synthetic
