// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Pictures of unusual scenes: never a crash, and never an empty image without a message.
#include "cvo_slam/render/picture.h"

#include <cmath>
#include <limits>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "cvo_slam/core/error.h"
#include "cvo_slam/render/motion_jpeg.h"
#include "cvo_slam/tests/render/test_scenes.h"
#include "cvo_slam/tests/temporary_folder.h"

namespace cvo_slam::render {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

SE3 pose_at(double x, double y, double z) { return {Matrix3::Identity(), {x, y, z}}; }

Picture draw(const MapScene& scene, ViewKind kind = ViewKind::kIso) {
  const auto renderer = make_renderer(RendererKind::kSplat);
  return draw_picture(scene, {.kind = kind, .width = 320, .height = 240}, *renderer);
}

/// Returns the number of pixels that differ clearly from the background.
std::size_t ink(const cv::Mat& image) {
  return pixels_where(image, [](const cv::Vec3b& bgr) { return bgr[0] < 150; }).size();
}

TEST(Picture, AnEmptySceneSaysSo) {
  for (const auto& [name, kind] : view_names()) {
    const Picture picture = draw({}, kind);
    EXPECT_EQ(picture.image.size(), cv::Size(320, 240));
    EXPECT_GT(ink(picture.image), 100U) << name;  // the words
    EXPECT_THAT(picture.notes, IsEmpty());
  }
}

TEST(Picture, OnePoseIsAPicture) {
  MapScene scene;
  scene.keyframes = {pose_at(3, 4, 5)};
  add_path_by_time(scene, "trajectory", {{Timestamp(), pose_at(3, 4, 5)}});
  for (const auto& [name, kind] : view_names())
    EXPECT_GT(ink(draw(scene, kind).image), 30U) << name;
}

// When a camera turned on the spot, as in fr1/rpy, its keyframes hid the path.
TEST(Picture, AKeyframeThatLooksAsAnotherOneIsNotDrawnOverIt) {
  MapScene scene;
  scene.keyframes = {pose_at(0, 0, 0), pose_at(1, 0.5, 0.5), pose_at(3, 1, 1)};
  // The new keyframes are inside the extent of the others, so that the framing stays the same.
  const cv::Mat three = draw(scene).image;
  scene.keyframes.push_back(pose_at(0.01, 0.01, 0.01));
  const cv::Mat covered = draw(scene).image;
  scene.keyframes.back() = pose_at(0.01, 0.01, 0.01) * SE3(so3_exp({0, 1, 0}), Vector3::Zero());
  // At first only a digit of the legend differs; then ten lines of ten pixels, by half of 3 x 255.
  constexpr double kFewPixels = 5'000;
  EXPECT_LT(cv::norm(three, covered, cv::NORM_L1), kFewPixels);
  EXPECT_GT(cv::norm(covered, draw(scene).image, cv::NORM_L1), kFewPixels);
}

TEST(Picture, PosesAndPointsThatAreNotFiniteAreLeftOutWithANote) {
  const MapScene good = floor_scene();
  MapScene scene = good;
  scene.points.push_back(map_point({kNaN, 0, 0}, {0, 0, 0}));
  scene.paths[0].poses.push_back({Timestamp::from_seconds(1), pose_at(0, kNaN, 0)});
  scene.paths[0].values.push_back(kNaN);
  scene.keyframes.push_back(pose_at(kNaN, 0, 0));
  scene.constraints.push_back({{0, 0, 0}, {kNaN, 0, 0}, EdgeKind::kLoop});
  const Picture picture = draw(scene);
  EXPECT_THAT(picture.notes, ElementsAre(HasSubstr("1 point left out: not finite"),
                                         HasSubstr("1 pose left out: not finite")));
  EXPECT_GT(ink(picture.image), ink(draw(good).image) / 2);
}

TEST(Picture, OnlyPosesThatAreNotFiniteSaySo) {
  MapScene scene;
  add_path_by_time(scene, "trajectory", {{Timestamp(), pose_at(kNaN, kNaN, kNaN)}});
  const Picture picture = draw(scene);
  EXPECT_GT(ink(picture.image), 100U);
  EXPECT_THAT(picture.notes, ElementsAre(HasSubstr("1 pose left out")));
}

TEST(Picture, FarFromTheOriginIsDrawnAndBeyondReasonIsLeftOut) {
  // Coordinates of a national grid: thousands of kilometres.
  MapScene scene;
  for (int i = 0; i < 10; ++i) scene.keyframes.push_back(pose_at(5e6 + i, 4e5, 100));
  EXPECT_GT(ink(draw(scene).image), 200U);
  scene.points.push_back(map_point({1e30, 0, 0}, {0, 0, 0}));
  const Picture picture = draw(scene);
  EXPECT_GT(ink(picture.image), 200U);
  EXPECT_THAT(picture.notes, ElementsAre(HasSubstr("1 point left out: not finite, or beyond")));
}

TEST(Picture, AnotherOriginMovesNothing) {
  MapScene scene = floor_scene();
  scene.constraints.push_back({{0, 0, 1}, {0.25, 0, 1}, EdgeKind::kLoop});
  MapScene far = scene;
  set_origin(far, {-2, 4, 0});  // exact in binary; the pictures' numbers differ
  EXPECT_EQ(far.points[0].position,
            Eigen::Vector3f(scene.points[0].position + Eigen::Vector3f(2, -4, 0)));
  EXPECT_EQ(far.paths[0].poses[0].T_world_camera.translation(),
            scene.paths[0].poses[0].T_world_camera.translation() + Vector3(2, -4, 0));
  EXPECT_EQ(far.keyframes[0].translation(), scene.keyframes[0].translation() + Vector3(2, -4, 0));
  EXPECT_EQ(far.constraints[0].to, Vector3(2.25, -4, 1));
  EXPECT_THAT(
      draw(far).notes,
      ElementsAre("far from the origin: axes and numbers of the picture begin at (-2, 4, 0) "
                  "m"));
}

TEST(Picture, ANormalThatIsNoUnitVectorIsDrawnAsOne) {
  MapScene scene = floor_scene();
  const cv::Mat unit = draw(scene).image;
  for (MapPoint& point : scene.points) point.normal *= 100;
  EXPECT_EQ(cv::norm(unit, draw(scene).image, cv::NORM_L1), 0);
}

TEST(Picture, StrayPointsDoNotShrinkTheMap) {
  MapScene scene = floor_scene();
  const std::size_t before = ink(draw(scene).image);
  for (int i = 0; i < 20; ++i) scene.points.push_back(map_point({500, 5.0 * i, 3}, {0, 0, 0}));
  EXPECT_NEAR(static_cast<double>(ink(draw(scene).image)), static_cast<double>(before),
              0.1 * static_cast<double>(before));
}

TEST(Picture, UpIsWhereTheFloorSaysNearWhereTheCamerasSay) {
  MapScene scene;
  const Vector3 up = Vector3(0.1, -1, 0.2).normalized();
  const Vector3 along = up.cross(Vector3::UnitX()).normalized();
  add_wall(scene, {0, 1, 0}, along, up.cross(along), 0.5, {1, 2, 3}, up);
  // Cameras tilted by 0.3 rad about x: the floor's normal is 29 degrees from their mean up
  // direction.
  const std::vector<SE3> cameras(3, SE3(so3_exp({0.3, 0, 0}), {0, 0, 0}));
  EXPECT_LT((estimate_up(cameras, scene.points) - up).norm(), 1e-3);
  EXPECT_EQ(estimate_up({}, {}), Vector3(-Vector3::UnitY()));
  EXPECT_LT((estimate_up(cameras, {}) - Vector3(0, -std::cos(0.3), -std::sin(0.3))).norm(), 1e-9);
}

TEST(Picture, UnwritableFilesAreErrors) {
  const TemporaryFolder folder;
  EXPECT_THROW(write_picture(folder.path() / "no" / "a.png", draw({}).image), OutputError);
}

TEST(MotionJpeg, IsAnAviFileOfJpegPictures) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "film.avi";
  MotionJpeg film;
  for (int i = 0; i < 3; ++i) film.add(cv::Mat(48, 64, CV_8UC3, cv::Scalar(0, 0, 80.0 * i)));
  film.write(file);
  const std::string bytes = read_text(file);
  EXPECT_THAT(bytes, testing::StartsWith("RIFF"));
  EXPECT_EQ(bytes.substr(8, 8), "AVI LIST");
  // The RIFF header holds the length of all that follows, the lowest byte first.
  std::uint32_t length = 0;
  for (int i = 3; i >= 0; --i) {
    length = (length << 8U) | static_cast<unsigned char>(bytes[4 + static_cast<std::size_t>(i)]);
  }
  EXPECT_EQ(length + 8, bytes.size());
  // The second picture decodes to its colour.
  const std::size_t first = bytes.find("00dc");
  const std::size_t second = bytes.find("00dc", first + 4);
  const std::vector<unsigned char> jpeg(bytes.begin() + static_cast<std::ptrdiff_t>(second) + 8,
                                        bytes.end());
  const cv::Mat image = cv::imdecode(jpeg, cv::IMREAD_COLOR);
  ASSERT_EQ(image.size(), cv::Size(64, 48));
  EXPECT_NEAR(image.at<cv::Vec3b>(10, 10)[2], 80, 3);
}

TEST(MotionJpeg, BadFilmsAreErrors) {
  const TemporaryFolder folder;
  MotionJpeg film;
  EXPECT_THROW(film.write(folder.path() / "a.avi"), OutputError);  // no picture
  film.add(cv::Mat(48, 64, CV_8UC3));
  EXPECT_THROW(film.add(cv::Mat(48, 65, CV_8UC3)), DataError);
  EXPECT_THROW(film.write(folder.path() / "a.mp4"), OptionError);
  EXPECT_THROW(film.write(folder.path() / "no" / "a.avi"), OutputError);
}

}  // namespace
}  // namespace cvo_slam::render
