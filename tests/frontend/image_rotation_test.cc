// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <numbers>
#include <utility>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "cvo_slam/frontend/image_rotation_internal.h"
#include "cvo_slam/frontend/tracker.h"
#include "cvo_slam/synthetic/rendering.h"
#include "cvo_slam/synthetic/world.h"
#include "cvo_slam/tests/frontend/test_frames.h"

namespace cvo_slam {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// What a camera sees that turns on the spot in the built-in room.
class TurningCamera {
 public:
  [[nodiscard]] RgbdFrame frame(std::size_t index, double seconds, const Vector3& turn) const {
    const auto seen = synthetic::render(
        world_.scene, camera.color, world_.path.T_world_camera(0) * SE3(so3_exp(turn), {0, 0, 0}));
    RgbdFrame frame;
    frame.index = index;
    frame.stamp = frame.depth_stamp = Timestamp::from_seconds(100 + seconds);
    seen.color.convertTo(frame.color, CV_8U);
    seen.depth.convertTo(frame.depth, CV_16U, camera.depth_scale);
    return frame;
  }
  [[nodiscard]] cv::Mat image(const Vector3& turn) const { return frame(0, 0, turn).color; }

  Camera camera = small_camera();

 private:
  synthetic::World world_ = synthetic::make_world("room");
};

double error_of(const ImageRotation& found, const Vector3& turn) {
  return so3_log(found.R_from_to.transpose() * so3_exp(turn)).norm();
}

const std::vector<Vector3>& turns() {
  static const std::vector<Vector3> all = {Vector3(0, 0.2, 0), Vector3(0, -0.28, 0),
                                           Vector3(0.15, 0, 0), Vector3(0, 0, 0.2),
                                           Vector3(-0.1, 0.15, 0.1)};
  return all;
}

TEST(ImageRotation, FindsTurnsInAnyDirectionWithoutAHint) {
  const TurningCamera camera;
  const cv::Mat first = camera.image(Vector3::Zero());
  for (const Vector3& turn : turns()) {
    SCOPED_TRACE(testing::Message() << turn.transpose());
    const ImageRotation found =
        find_image_rotation(first, camera.image(turn), camera.camera.color, Matrix3::Identity());
    EXPECT_LT(error_of(found, turn), 0.5 * kDegree);
    EXPECT_GT(found.correlation, 0.9);
  }
}

TEST(ImageRotation, TheExposureChangesNothing) {
  const TurningCamera camera;
  const cv::Mat first = camera.image(Vector3::Zero());
  const cv::Mat second = camera.image({0, 0.2, 0.05});
  cv::Mat changed;
  second.convertTo(changed, -1, 0.5, 40);
  const auto rotation_to = [&](const cv::Mat& to) {
    return find_image_rotation(first, to, camera.camera.color, Matrix3::Identity()).R_from_to;
  };
  EXPECT_LT(so3_log(rotation_to(second).transpose() * rotation_to(changed)).norm(), 1e-3);
}

TEST(ImageRotation, OfGreyImagesIsTheSame) {
  const TurningCamera camera;
  const Vector3 turn(0, 0.2, 0);
  cv::Mat from;
  cv::Mat to;
  cv::cvtColor(camera.image(Vector3::Zero()), from, cv::COLOR_BGR2GRAY);
  cv::cvtColor(camera.image(turn), to, cv::COLOR_BGR2GRAY);
  EXPECT_LT(error_of(find_image_rotation(from, to, camera.camera.color, Matrix3::Identity()), turn),
            0.5 * kDegree);
}

TEST(ImageRotation, ImagesWithNothingInCommonLeaveTheMotionAsItIs) {
  const TurningCamera camera;
  const SE3 motion(so3_exp({0.01, 0.02, 0.03}), {1, 2, 3});
  const auto rotation_after = [&](const cv::Mat& to) {
    return turned_as_seen(motion, camera.image(Vector3::Zero()), to, camera.camera.color);
  };
  for (const cv::Mat& to : {camera.image({0, std::numbers::pi, 0}),
                            cv::Mat(240, 320, CV_8UC3, cv::Scalar(90, 90, 90))}) {
    EXPECT_EQ(rotation_after(to).matrix(), motion.matrix());
  }
  const SE3 turned = rotation_after(camera.image({0, 0.2, 0}));
  EXPECT_EQ(turned.translation(), motion.translation());
  EXPECT_LT(so3_log(turned.rotation().transpose() * so3_exp({0, 0.2, 0})).norm(), 0.5 * kDegree);
}

TEST(ImageRotation, WorksForAnySizeOfImage) {
  for (const auto& [width, height] : {std::pair{8, 6}, {2, 2}, {400, 12}, {12, 400}, {240, 320}}) {
    SCOPED_TRACE(testing::Message() << width << "x" << height);
    const Camera camera = small_camera(width, height);
    const cv::Mat image = noise_image(camera, 5);
    const ImageRotation found =
        find_image_rotation(image, image, camera.color, Matrix3::Identity());
    EXPECT_LT(so3_log(found.R_from_to).norm(), 0.02);
    EXPECT_TRUE(std::isfinite(found.correlation));
  }
}

/// A head that turns to and fro, seen five times a second: the velocity is wrong each time.
TEST(Tracker, FollowsTurnsThatItsVelocityDoesNotForesee) {
  const TurningCamera camera;
  Tracker tracker(camera.camera);
  for (std::size_t i = 0; i < 6; ++i) {
    const Vector3 turn(0, i % 2 == 0 ? 0 : 0.28, 0);
    const FrameRecord record =
        tracker.track(camera.frame(i, 0.2 * static_cast<double>(i), turn)).record;
    ASSERT_EQ(record.status, TrackingStatus::kTracked) << i << ": " << record.reason;
    EXPECT_LT(so3_log(record.T_world_camera.rotation().transpose() * so3_exp(turn)).norm(),
              0.5 * kDegree)
        << i;
    EXPECT_LT(record.T_world_camera.translation().norm(), 0.01) << i;
  }
}

}  // namespace
}  // namespace cvo_slam
