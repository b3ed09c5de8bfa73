// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/io/depth_registration.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/tests/io/tiny_sequence.h"

namespace cvo_slam {
namespace {

/// A plane n . p = d in the frame of the depth camera.
struct Plane {
  Vector3 normal;
  double distance;

  /// Returns the same plane in another frame.
  [[nodiscard]] Plane seen_from(const SE3& T_other_depth) const {
    const Vector3 n = T_other_depth.rotation() * normal;
    return {n, distance + n.dot(T_other_depth.translation())};
  }
  /// Returns z of the point where the ray of a pixel meets the plane [m].
  [[nodiscard]] double depth_at(const PinholeCamera& camera, int u, int v) const {
    return distance / normal.dot(camera.unproject({u, v}));
  }
};

/// Returns a colour and a depth camera side by side as in a Kinect, both with distortion; depth is
/// in units of 0.1 mm.
Camera kinect() {
  Camera camera;
  camera.depth_scale = 10000;
  camera.color.distortion = {0.05, -0.1, 0.001, -0.002, 0.02};
  DepthCamera depth;
  depth.pinhole.fx = depth.pinhole.fy = 585;
  depth.pinhole.distortion = {-0.04, 0.08, 0.0005, 0.001, 0};
  depth.T_color_depth =
      SE3::exp((Vector6() << -0.0256, 0.001, 0.002, 0.004, -0.006, 0.003).finished());
  camera.depth = depth;
  return camera;
}

cv::Mat render(const Camera& camera, const std::function<double(int, int)>& depth_at) {
  const PinholeCamera& pinhole = camera.depth->pinhole;
  cv::Mat image(pinhole.height, pinhole.width, CV_16UC1);
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) {
      image.at<std::uint16_t>(v, u) =
          static_cast<std::uint16_t>(std::lround(depth_at(u, v) * camera.depth_scale));
    }
  }
  return image;
}

cv::Mat render(const Camera& camera, const Plane& plane) {
  return render(camera, [&](int u, int v) { return plane.depth_at(camera.depth->pinhole, u, v); });
}

/// Depth is rounded to whole units of 0.1 mm twice: in the image and in the result [m].
constexpr double kQuantisation = 0.0001;

/// Returns the largest permitted error of the depth of a colour pixel [m]: the depth is that of the
/// centre of a footprint, whose half size is 0.65 depth pixels of `pixel_ratio` colour pixels each.
double tolerance_at(const Plane& plane, const PinholeCamera& camera, int u, int v,
                    double pixel_ratio) {
  const double here = plane.depth_at(camera, u, v);
  const double per_pixel = std::abs(plane.depth_at(camera, u + 1, v) - here) +
                           std::abs(plane.depth_at(camera, u, v + 1) - here);
  return kQuantisation + 0.65 * pixel_ratio * per_pixel;
}

/// Expects `plane` all over `registered` except for a border that the depth camera does not see.
void expect_plane(const Camera& camera, const Plane& plane, const cv::Mat& registered, int border) {
  const Plane seen = plane.seen_from(camera.depth->T_color_depth);
  // Distortion and perspective change the size of a pixel by up to 2 %.
  const double pixel_ratio = 1.02 * camera.color.fx / camera.depth->pinhole.fx;
  int holes = 0;
  int wrong = 0;
  for (int v = border; v < registered.rows - border; ++v) {
    for (int u = border; u < registered.cols - border; ++u) {
      const int units = registered.at<std::uint16_t>(v, u);
      const double error = units / camera.depth_scale - seen.depth_at(camera.color, u, v);
      holes += units == 0 ? 1 : 0;
      wrong += std::abs(error) > tolerance_at(seen, camera.color, u, v, pixel_ratio) ? 1 : 0;
    }
  }
  EXPECT_EQ(holes, 0);
  EXPECT_EQ(wrong, 0);
}

/// Width of the border that the depth camera does not see [px]: 10 % of the image by its focal
/// length of 585 instead of 525 px, and 7 px by the baseline at 2 m.
constexpr int kBorder = 60;

TEST(DepthRegistration, KeepsAPlaneAcrossTheView) {
  const Camera camera = kinect();
  const Plane plane{Vector3(0, 0, 1), 2.0};
  expect_plane(camera, plane, DepthRegistration(camera).register_depth(render(camera, plane)),
               kBorder);
}

TEST(DepthRegistration, KeepsASlantedPlaneWithoutPinholes) {
  const Camera camera = kinect();
  const Plane plane{Vector3(-0.6, 0.3, 0.742).normalized(), 1.2};
  expect_plane(camera, plane, DepthRegistration(camera).register_depth(render(camera, plane)),
               kBorder);
}

TEST(DepthRegistration, ANearObjectHidesWhatIsBehind) {
  const Camera camera = kinect();
  const int edge = 320;  // px in the depth image: near on its left, far on its right
  const double near = 1.0;
  const double far = 3.0;
  const cv::Mat registered = DepthRegistration(camera).register_depth(
      render(camera, [&](int u, int /*v*/) { return u < edge ? near : far; }));
  const auto edge_in_color = [&](double depth) {
    const Vector3 point = depth * camera.depth->pinhole.unproject({edge - 0.5, 240});
    return camera.color.project(camera.depth->T_color_depth * point);
  };
  const int v = static_cast<int>(std::lround(edge_in_color(near).y()));
  const double near_ends = edge_in_color(near).x();
  const double far_begins = edge_in_color(far).x();
  // The colour camera is on the right: it sees a part of the wall that is hidden from the depth
  // camera.
  ASSERT_GT(far_begins, near_ends + 5);
  for (int u = 200; u < 450; ++u) {
    const double depth = registered.at<std::uint16_t>(v, u) / camera.depth_scale;
    // 1 px: footprints reach 0.65 px, of which 0.5 is the pixel's own half.
    if (u < near_ends - 1) {
      EXPECT_NEAR(depth, near, 0.02) << u;
    } else if (u > near_ends + 1 && u < far_begins - 1) {
      EXPECT_EQ(depth, 0) << u;
    } else if (u > far_begins + 1) {
      EXPECT_NEAR(depth, far, 0.04) << u;
    }
  }
}

TEST(DepthRegistration, OverlappingSurfacesGiveTheNearer) {
  Camera camera = kinect();
  // With the colour camera on the left, the near surface on the left hides a part of the far one.
  camera.depth->T_color_depth = SE3(Matrix3::Identity(), Vector3(0.05, 0, 0));
  const cv::Mat registered = DepthRegistration(camera).register_depth(
      render(camera, [](int u, int /*v*/) { return u < 320 ? 1.0 : 3.0; }));
  const Vector3 edge = camera.depth->pinhole.unproject({319, 240});
  const auto pixel = camera.color.project(camera.depth->T_color_depth * edge);
  const int v = static_cast<int>(std::lround(pixel.y()));
  for (int u = 300; u < pixel.x(); ++u) {
    EXPECT_NEAR(registered.at<std::uint16_t>(v, u) / camera.depth_scale, 1.0, 0.001) << u;
  }
}

TEST(DepthRegistration, FillsALargerColourImage) {
  Camera camera = kinect();
  camera.color.width = 1280;
  camera.color.height = 720;
  camera.color.fx = camera.color.fy = 920;
  camera.color.cx = 640;
  camera.color.cy = 360;
  camera.depth->pinhole.fx = camera.depth->pinhole.fy = 380;
  const Plane plane{Vector3(0, 0.3, 1).normalized(), 1.5};
  expect_plane(camera, plane, DepthRegistration(camera).register_depth(render(camera, plane)), 40);
}

TEST(DepthRegistration, AnEmptyImageStaysEmpty) {
  const DepthRegistration registration(kinect());
  EXPECT_EQ(cv::countNonZero(registration.register_depth(cv::Mat::zeros(480, 640, CV_16UC1))), 0);
}

TEST(DepthRegistration, DropsWhatIsBehindTheColourCamera) {
  Camera camera = kinect();
  camera.depth->T_color_depth = SE3(Matrix3::Identity(), Vector3(0, 0, -1));
  const cv::Mat half_a_metre(480, 640, CV_16UC1, cv::Scalar(5000));
  EXPECT_EQ(cv::countNonZero(DepthRegistration(camera).register_depth(half_a_metre)), 0);
}

TEST(DepthRegistration, RefusesWhatItCannotRegister) {
  EXPECT_THROW(DepthRegistration{Camera()}, OptionError);
  const DepthRegistration registration(kinect());
  EXPECT_THROW(static_cast<void>(registration.register_depth(cv::Mat::zeros(48, 64, CV_16UC1))),
               Error);
  EXPECT_THROW(static_cast<void>(registration.register_depth(cv::Mat::zeros(480, 640, CV_8UC1))),
               Error);
}

TEST(DepthRegistration, ServesTheTumLayoutWithADepthCameraOfAnotherSize) {
  const TinySequence sequence;
  sequence.write_tum();
  Camera camera = tiny_camera();
  DepthCamera depth;
  depth.pinhole = camera.color;
  depth.pinhole.width = 16;
  depth.pinhole.height = 12;
  depth.pinhole.fx = depth.pinhole.fy = 16;
  depth.pinhole.cx = 7.5;
  depth.pinhole.cy = 5.5;
  camera.depth = depth;
  EXPECT_NE(sequence.open(camera)->read(0).problem, "");
  sequence.write_image("depth/0.png", cv::Mat(12, 16, CV_16UC1, cv::Scalar(5000)));
  const RgbdFrame frame = sequence.open(camera)->read(0);
  EXPECT_EQ(frame.problem, "");
  EXPECT_EQ(frame.depth.size(), frame.color.size());
  EXPECT_EQ(cv::countNonZero(frame.depth == 5000), 48);
}

}  // namespace
}  // namespace cvo_slam
