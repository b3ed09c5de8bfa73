// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "cvo_slam/frontend/motion_model_internal.h"
#include "cvo_slam/tests/frontend/test_clouds.h"

namespace cvo_slam {
namespace {

Timestamp at(double seconds) { return Timestamp::from_seconds(seconds); }

void expect_near(const SE3& a, const SE3& b) {
  EXPECT_LT((a.inverse() * b).log().norm(), 1e-12);  // rounding
}

const SE3 kStart = motion(1, 2, 3, 0.1, 0.2, 0.3);
/// The camera's motion in a second, in its own frame.
const Vector6 kVelocity = (Vector6() << 0.3, -0.2, 0.5, 0.4, -0.6, 0.2).finished();

SE3 pose_after(double seconds) { return kStart * SE3::exp(seconds * kVelocity); }

TEST(MotionModel, StaysAtTheOriginBeforeTheFirstPose) {
  const MotionModel model;
  expect_near(model.predict(at(5)), SE3());
  expect_near(model.motion_during(1), SE3());
}

TEST(MotionModel, StaysAtTheFirstPose) {
  MotionModel model;
  model.update(at(10), kStart);
  expect_near(model.predict(at(11)), kStart);
  expect_near(model.motion_during(1), SE3());
  expect_near(model.last_pose(), kStart);
  EXPECT_EQ(model.last_stamp(), at(10));
}

TEST(MotionModel, ExtrapolatesConstantVelocityExactly) {
  MotionModel model;
  model.update(at(10), kStart);
  model.update(at(10.5), pose_after(0.5));
  for (const double later : {0.5, 0.53, 1.0, 2.5}) {
    expect_near(model.predict(at(10 + later)), pose_after(later));
  }
}

TEST(MotionModel, MotionIsThePoseOfTheLaterCameraInTheEarlierOne) {
  MotionModel model;
  model.update(at(10), kStart);
  model.update(at(11), pose_after(1));
  expect_near(model.motion_during(0.017), pose_after(1).inverse() * pose_after(1.017));
  expect_near(model.motion_during(-0.017), pose_after(1).inverse() * pose_after(0.983));
}

TEST(MotionModel, TakesTheVelocityOfTheLastTwoPoses) {
  MotionModel model;
  model.update(at(10), kStart * motion(0.3, 0, 0, 0, 0.2, 0));
  model.update(at(10.1), kStart);
  model.update(at(10.3), pose_after(0.2));
  expect_near(model.predict(at(10.4)), pose_after(0.3));
}

TEST(MotionModel, ForgettingTheVelocityKeepsThePose) {
  MotionModel model;
  model.update(at(10), kStart);
  model.update(at(11), pose_after(1));
  model.forget_velocity();
  expect_near(model.predict(at(12)), pose_after(1));
  expect_near(model.motion_during(1), SE3());
  // The next pose gives the mean velocity over the gap.
  model.update(at(13), pose_after(3));
  expect_near(model.predict(at(14)), pose_after(4));
}

TEST(MotionModel, TwoPosesOfOneTimeGiveNoVelocity) {
  MotionModel model;
  model.update(at(10), kStart);
  model.update(at(10), pose_after(1));
  expect_near(model.predict(at(11)), pose_after(1));
}

TEST(RollingShutter, IsUndone) {
  // The points as seen by rows that were read before, at and after the stamp, by a camera with this
  // velocity.
  constexpr double kReadout = 0.026;
  constexpr int kRows = 480;
  Vector6 velocity;
  velocity << 0.3, -0.2, 0.1, 0.5, -1.0, 0.8;
  const PointCloud truth = random_cloud(30, 1);
  PointCloud seen = truth;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    seen.v[i] = static_cast<float>(i * 16);
    const double dt = (static_cast<double>(i * 16) - 239.5) / kRows * kReadout;
    const Vector3 p = SE3::exp(dt * velocity).inverse() * truth.position(i);
    seen.x[i] = static_cast<float>(p.x());
    seen.y[i] = static_cast<float>(p.y());
    seen.z[i] = static_cast<float>(p.z());
  }
  PointCloud undone = seen;
  undo_rolling_shutter(velocity, kReadout, kRows, undone);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    // The neglected second order of 1.4 rad/s in 13 ms: (0.018)^2 / 2 of 2 m.
    EXPECT_LT((undone.position(i) - truth.position(i)).norm(), 4e-4) << i;
  }
  EXPECT_GT((seen.position(0) - truth.position(0)).norm(), 0.01) << "there was something to undo";
}

TEST(RollingShutter, OfACameraAtRestChangesNothing) {
  PointCloud cloud = random_cloud(5, 2);
  const PointCloud seen = cloud;
  undo_rolling_shutter(Vector6::Zero(), 0.03, 480, cloud);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    EXPECT_EQ(cloud.position(i), seen.position(i));
  }
}

}  // namespace
}  // namespace cvo_slam
