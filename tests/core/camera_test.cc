// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/core/camera.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/core/error.h"

namespace cvo_slam {
namespace {

using testing::HasSubstr;

PinholeCamera distorted_camera() {
  PinholeCamera camera;
  camera.fx = 517.3;
  camera.fy = 516.5;
  camera.cx = 318.6;
  camera.cy = 255.3;
  camera.distortion = {0.2624, -0.9531, -0.0054, 0.0026, 1.1633};
  return camera;
}

TEST(PinholeCamera, UnprojectInvertsProjectAllOverTheImage) {
  PinholeCamera flipped;
  flipped.fy = -480;  // ICL-NUIM
  for (const PinholeCamera& camera : {PinholeCamera(), distorted_camera(), flipped}) {
    for (int v = 0; v < camera.height; v += 20) {
      for (int u = 0; u < camera.width; u += 20) {
        const Eigen::Vector2d pixel(u, v);
        EXPECT_LT((camera.project(2.5 * camera.unproject(pixel)) - pixel).norm(), 1e-6);
      }
    }
  }
}

TEST(PinholeCamera, ThePrincipalPointLooksAlongTheAxis) {
  const PinholeCamera camera = distorted_camera();
  EXPECT_LT((camera.project(Vector3(0, 0, 3)) - Eigen::Vector2d(camera.cx, camera.cy)).norm(),
            1e-12);
}

TEST(PinholeCamera, DistortionIsBrownsModel) {
  PinholeCamera camera;
  camera.fx = camera.fy = 1;
  camera.cx = camera.cy = 0;
  camera.distortion = {0.1, 0.01, 0.001, 0.002, 0.0001};
  const double x = 0.3;
  const double y = -0.2;
  const double r2 = x * x + y * y;
  const double radial = 1 + 0.1 * r2 + 0.01 * r2 * r2 + 0.0001 * r2 * r2 * r2;
  const Eigen::Vector2d pixel = camera.project(Vector3(x, y, 1));
  EXPECT_NEAR(pixel.x(), x * radial + 2 * 0.001 * x * y + 0.002 * (r2 + 2 * x * x), 1e-15);
  EXPECT_NEAR(pixel.y(), y * radial + 0.001 * (r2 + 2 * y * y) + 2 * 0.002 * x * y, 1e-15);
}

TEST(PinholeCamera, ContainsReachesHalfAPixelBeyondTheCentres) {
  const PinholeCamera camera;
  EXPECT_TRUE(camera.contains({-0.4, 479.4}));
  EXPECT_FALSE(camera.contains({-0.6, 0}));
  EXPECT_FALSE(camera.contains({639.6, 0}));
}

TEST(Camera, CheckRejectsImpossibleValues) {
  Camera camera;
  EXPECT_NO_THROW(camera.check());
  camera.depth_scale = 0;
  EXPECT_THROW(camera.check(), OptionError);
  camera = Camera();
  camera.color.fx = std::nan("");
  EXPECT_THROW(camera.check(), OptionError);
  camera = Camera();
  camera.depth = DepthCamera();
  camera.depth->pinhole.height = 0;
  EXPECT_THROW(camera.check(), OptionError);
}

/// Returns the problem of a camera that `change` has changed.
template <typename Change>
std::string problem_of(const Change& change) {
  Camera camera;
  change(camera);
  try {
    camera.check();
  } catch (const OptionError& error) {
    return error.what();
  }
  return "none";
}

TEST(Camera, CheckRefusesFocalLengthsInOtherUnits) {
  // Millimetres, image widths, and a focal length of an image ten times as large and more.
  for (const double fx : {3.5, 0.82, 70000.0}) {
    EXPECT_THAT(problem_of([&](Camera& c) { c.color.fx = fx; }),
                HasSubstr("does not fit the width of 640 px"));
    EXPECT_THAT(problem_of([&](Camera& c) { c.color.fy = -fx; }),
                HasSubstr("does not fit the height of 480 px"));
  }
  EXPECT_THAT(problem_of([](Camera& c) { c.color.fx = 5 * c.color.fy; }), HasSubstr("differ"));
  // A lens of 120 degrees, a telephoto lens of 4 degrees, and ICL-NUIM.
  EXPECT_EQ(problem_of([](Camera& c) { c.color.fx = c.color.fy = 185; }), "none");
  EXPECT_EQ(problem_of([](Camera& c) { c.color.fx = c.color.fy = 9000; }), "none");
  EXPECT_EQ(problem_of([](Camera& c) { c.color.fy = -480; }), "none");
}

TEST(Camera, CheckRefusesAPrincipalPointOutsideTheImage) {
  for (const double cx : {-1.0, 640.0, 1e9}) {
    EXPECT_THAT(problem_of([&](Camera& c) { c.color.cx = cx; }), HasSubstr("is outside the image"));
  }
  EXPECT_THAT(problem_of([](Camera& c) { c.color.cy = 500; }), HasSubstr("is outside the image"));
  EXPECT_EQ(problem_of([](Camera& c) { c.color.cx = 0; }), "none");
}

TEST(Camera, CheckRefusesDistortionThatNoLensHas) {
  const auto with = [](std::array<double, 5> distortion) {
    return problem_of([&](Camera& c) { c.color.distortion = distortion; });
  };
  EXPECT_THAT(with({0, 0, 636, 0, 0}), HasSubstr("p1=636"));
  EXPECT_THAT(with({0, 0, 0, -0.6, 0}), HasSubstr("no lens has the distortion"));
  EXPECT_THAT(with({517, 0, 0, 0, 0}), HasSubstr("no lens has the distortion"));
  EXPECT_THAT(with({0, 0, 0, 0, 636}), HasSubstr("no lens has the distortion"));
  // TUM fr1, and a wide lens with much barrel distortion.
  EXPECT_EQ(with({0.2624, -0.9531, -0.0054, 0.0026, 1.1633}), "none");
  EXPECT_EQ(with({-0.35, 0.15, 0.001, -0.001, -0.03}), "none");
}

TEST(Camera, CheckRefusesImpossibleDepth) {
  // 0.001 is the inverse of millimetres, a common mistake.
  EXPECT_THAT(problem_of([](Camera& c) { c.depth_scale = 0.001; }), HasSubstr("1000 for mill"));
  EXPECT_THAT(problem_of([](Camera& c) { c.depth_scale = 1e7; }), HasSubstr("more than 1e6"));
  EXPECT_EQ(problem_of([](Camera& c) { c.depth_scale = 1; }), "none");
  const auto apart = [](double baseline) {
    return problem_of([&](Camera& c) {
      c.depth = DepthCamera{PinholeCamera(), SE3(Matrix3::Identity(), {baseline, 0, 0})};
    });
  };
  EXPECT_EQ(apart(0.025), "none");
  EXPECT_THAT(apart(25), HasSubstr("in metres, not in millimetres"));
}

TEST(Camera, CheckRefusesImagesThatWouldFillTheMemory) {
  EXPECT_THAT(problem_of([](Camera& c) {
                c.depth = DepthCamera();
                c.depth->pinhole.width = c.depth->pinhole.height = 65536;
              }),
              HasSubstr("image size 65536x65536 is too large"));
  EXPECT_THAT(problem_of([](Camera& c) { c.color.width = c.color.height = 16384; }),
              HasSubstr("is too large"));
}

}  // namespace
}  // namespace cvo_slam
