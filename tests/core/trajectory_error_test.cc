// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <numbers>

#include <Eigen/LU>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/trajectory_errors.h"
#include "cvo_slam/tests/core/trajectory_samples.h"

namespace cvo_slam {
namespace {

using testing::ElementsAre;
using Pair = std::pair<std::size_t, std::size_t>;

/// Returns the estimate that `similarity` maps to `poses`.
std::vector<StampedPose> inverse_transformed(const Similarity& similarity,
                                             const std::vector<StampedPose>& poses) {
  const SE3 back = similarity.T_reference_estimate.inverse();
  auto result = poses;
  for (auto& pose : result) {
    const SE3 moved = back * pose.T_world_camera;
    pose.T_world_camera = SE3(moved.rotation(), moved.translation() / similarity.scale);
  }
  return result;
}

const Similarity kMoved{SE3(so3_exp({0.3, -1.2, 2.0}), {4, -5, 6}), 1};
const Similarity kMovedAndScaled{SE3(so3_exp({0.3, -1.2, 2.0}), {4, -5, 6}), 2.5};

void expect_near(const Similarity& a, const Similarity& b) {
  EXPECT_NEAR(a.scale, b.scale, 1e-12);
  EXPECT_LT((a.T_reference_estimate.matrix() - b.T_reference_estimate.matrix()).norm(), 1e-11);
}

TEST(Alignment, RecoversAMotion) {
  const auto truth = helix(40);
  const auto matches = match(truth, inverse_transformed(kMoved, truth));
  expect_near(align_positions(matches, Alignment::kSe3), kMoved);
}

TEST(Alignment, RecoversMotionAndScale) {
  const auto truth = helix(40);
  const auto matches = match(truth, inverse_transformed(kMovedAndScaled, truth));
  expect_near(align_positions(matches, Alignment::kSim3), kMovedAndScaled);
}

TEST(Alignment, OfAMirrorImageIsStillARotation) {
  const auto truth = helix(40);
  auto estimate = truth;
  for (auto& pose : estimate) {
    const Vector3& t = pose.T_world_camera.translation();
    pose.T_world_camera = SE3(pose.T_world_camera.rotation(), {t.x(), t.y(), -t.z()});
  }
  const auto alignment = align_positions(match(truth, estimate), Alignment::kSe3);
  EXPECT_NEAR(alignment.T_reference_estimate.rotation().determinant(), 1, 1e-12);
}

TEST(Alignment, OfPositionsInAPlaneIsUnique) {
  auto truth = helix(40);
  for (auto& pose : truth) {
    Vector3 t = pose.T_world_camera.translation();
    t.z() = 0;
    pose.T_world_camera = SE3(pose.T_world_camera.rotation(), t);
  }
  const auto matches = match(truth, inverse_transformed(kMovedAndScaled, truth));
  expect_near(align_positions(matches, Alignment::kSim3), kMovedAndScaled);
}

TEST(Alignment, SaysWhenItIsNotUnique) {
  const auto still = line(5, 0);
  const auto straight = line(5);
  const auto curved = helix(5);
  for (const auto alignment : {Alignment::kSe3, Alignment::kSim3}) {
    EXPECT_THROW(static_cast<void>(align_positions(match(curved, still), alignment)), DataError);
    EXPECT_THROW(static_cast<void>(align_positions(match(still, curved), alignment)), DataError);
    EXPECT_THROW(static_cast<void>(align_positions(match(straight, straight), alignment)),
                 DataError);
    EXPECT_THROW(static_cast<void>(align_positions(match(curved, helix(2)), alignment)), DataError);
    EXPECT_THROW(static_cast<void>(align_positions({}, alignment)), DataError);
  }
}

TEST(AbsoluteTrajectoryError, OfAMovedCopyIsZeroAfterAlignment) {
  const auto truth = helix(40);
  const auto ate = absolute_trajectory_error(match(truth, inverse_transformed(kMoved, truth)));
  EXPECT_EQ(ate.errors.size(), 40U);
  EXPECT_LT(ate.statistics.translation.max, 1e-12);
  EXPECT_LT(ate.statistics.rotation.max, 1e-7);
}

TEST(AbsoluteTrajectoryError, WithoutAlignmentIsTheDistance) {
  const auto truth = line(2);
  auto estimate = truth;
  estimate[0].T_world_camera = SE3(so3_exp({0, 0.5, 0}), {0, 3, 4});
  const auto ate = absolute_trajectory_error(match(truth, estimate), Alignment::kNone);
  EXPECT_DOUBLE_EQ(ate.errors[0].translation, 5);
  EXPECT_DOUBLE_EQ(ate.errors[0].rotation, 0.5);
  EXPECT_DOUBLE_EQ(ate.errors[1].translation, 0);
  EXPECT_DOUBLE_EQ(ate.statistics.translation.sse, 25);
  EXPECT_EQ(ate.errors[1].stamp, milliseconds(100));
  EXPECT_THROW(static_cast<void>(absolute_trajectory_error({}, Alignment::kNone)), DataError);
}

TEST(RelativePoseError, DoesNotSeeWhereTheWorldIs) {
  const auto truth = helix(40);
  const auto rpe = relative_pose_error(match(truth, inverse_transformed(kMoved, truth)));
  // Poses are 100 ms apart: 40 of them have 30 pairs a second apart.
  EXPECT_EQ(rpe.errors.size(), 30U);
  EXPECT_LT(rpe.statistics.translation.max, 1e-12);
}

TEST(RelativePoseError, IsTheDifferenceOfTheMotions) {
  // The estimate goes 1.5 m and turns by 0.2 where the truth goes 1 m straight on.
  auto estimate = line(2, 1.5);
  estimate[1].T_world_camera = SE3(so3_exp({0, 0, 0.2}), {1.5, 0, 0});
  const auto matches = match(line(2), estimate);
  const auto rpe = relative_pose_error(matches, {.unit = DeltaUnit::kFrames});
  ASSERT_EQ(rpe.errors.size(), 1U);
  EXPECT_DOUBLE_EQ(rpe.errors[0].translation, 0.5);
  EXPECT_NEAR(rpe.errors[0].rotation, 0.2, 1e-15);
  EXPECT_EQ(rpe.errors[0].stamp, milliseconds(100));

  // R2 = I, T2 = (1, 0, 0): |T1 - R1 T2| = |(1.5 - cos 0.2, -sin 0.2)|, |log R1|_F = sqrt(2) 0.2.
  const auto paper = relative_pose_error(matches, cvo_paper_options());
  EXPECT_NEAR(paper.errors[0].translation, std::hypot(1.5 - std::cos(0.2), std::sin(0.2)), 1e-15);
  EXPECT_NEAR(paper.errors[0].rotation, std::numbers::sqrt2 * 0.2, 1e-15);
}

std::vector<Pair> pairs_of(const std::vector<StampedPose>& poses,
                           const RelativePoseOptions& options) {
  return select_pairs(match(poses, poses), options);
}

TEST(SelectPairs, ByFrames) {
  EXPECT_THAT(pairs_of(line(5), {.delta = 2, .unit = DeltaUnit::kFrames}),
              ElementsAre(Pair(0, 2), Pair(1, 3), Pair(2, 4)));
  EXPECT_THAT(pairs_of(line(6), {.delta = 2, .unit = DeltaUnit::kFrames, .all_pairs = false}),
              ElementsAre(Pair(0, 2), Pair(2, 4)));
  EXPECT_TRUE(pairs_of(line(2), {.delta = 2, .unit = DeltaUnit::kFrames}).empty());
  EXPECT_TRUE(pairs_of(line(2), {.delta = 1e300, .unit = DeltaUnit::kFrames}).empty());
}

TEST(SelectPairs, ByMetresCutsThePathAndDropsItsBeginning) {
  // Cuts at 2, 4, 6 m: as in evo the way to the first cut makes no pair.
  EXPECT_THAT(pairs_of(line(8), {.delta = 1.5, .unit = DeltaUnit::kMetres, .all_pairs = false}),
              ElementsAre(Pair(2, 4), Pair(4, 6)));
}

TEST(SelectPairs, ByMetresFromEveryPoseToTheNearest) {
  // 2.1 m is missed by 0.1 m at 2 m; 10 % of it is allowed.
  EXPECT_THAT(pairs_of(line(5), {.delta = 2.1, .unit = DeltaUnit::kMetres}),
              ElementsAre(Pair(0, 2), Pair(1, 3), Pair(2, 4)));
  EXPECT_TRUE(pairs_of(line(5), {.delta = 2.5, .unit = DeltaUnit::kMetres}).empty());
}

TEST(SelectPairs, ByMetresOfAStandingCameraTakesTheFirstOfEquals) {
  auto poses = line(5);
  poses[3].T_world_camera = poses[2].T_world_camera;  // positions 0, 1, 2, 2, 4
  EXPECT_THAT(pairs_of(poses, {.delta = 1.05, .unit = DeltaUnit::kMetres}),
              ElementsAre(Pair(0, 1), Pair(1, 2)));
}

TEST(SelectPairs, BySecondsIsTheFirstAtLeastThatFar) {
  auto poses = line(6);
  poses[3].stamp = milliseconds(340);  // 240 ms after poses[1]: within 50 ms of 0.2 s
  poses[5].stamp = milliseconds(650);  // 310 ms after poses[3]: more than a usual step beyond
  EXPECT_THAT(pairs_of(poses, {.delta = 0.2}),
              ElementsAre(Pair(0, 2), Pair(1, 3), Pair(2, 4), Pair(4, 5)));
  EXPECT_THAT(pairs_of(poses, {.delta = 0.2, .all_pairs = false}),
              ElementsAre(Pair(0, 2), Pair(2, 4), Pair(4, 5)));
}

TEST(SelectPairs, BySecondsMayMissTheDeltaByOneStepOfALowRate) {
  // Two steps of 0.1 s are too short, and the third pose is 90 ms beyond.
  EXPECT_THAT(pairs_of(line(5), {.delta = 0.21, .time_tolerance = 0.01}),
              ElementsAre(Pair(0, 3), Pair(1, 4)));
}

TEST(WrongPoses, AreThoseSinceTheLastRightOneUntilTheEstimateIsBack) {
  const auto truth = line(6);  // 1 m a step
  auto estimate = truth;
  for (const std::size_t i : {2U, 3U}) {
    SE3& pose = estimate[i].T_world_camera;
    pose = SE3(so3_exp({0, 0, i == 3 ? 0.1 : 0}), pose.translation() + Vector3(0, 0.2, 0));
  }
  const auto wrong = find_wrong_poses(match(truth, estimate));
  ASSERT_EQ(wrong.size(), 2U);
  EXPECT_EQ(wrong[0].stamp, truth[2].stamp);
  EXPECT_NEAR(wrong[0].translation, 0.2, 1e-12);
  EXPECT_EQ(wrong[1].stamp, truth[3].stamp);
  EXPECT_NEAR(wrong[1].rotation, 0.1, 1e-12);
}

TEST(WrongPoses, ADriftIsNotWrong) {
  const auto truth = line(6);
  auto estimate = truth;
  for (std::size_t i = 0; i < estimate.size(); ++i) {
    SE3& pose = estimate[i].T_world_camera;
    pose = SE3(pose.rotation(), pose.translation() * 1.09);  // 9 cm a step
  }
  EXPECT_TRUE(find_wrong_poses(match(truth, estimate)).empty());
  EXPECT_EQ(find_wrong_poses(match(truth, estimate), {.translation = 0.08}).size(), 5U);
}

TEST(RelativePoseError, RejectsImpossibleOptions) {
  const auto poses = line(3);
  const auto matches = match(poses, poses);
  const double nan = std::nan("");
  for (const double delta : {0.0, -1.0, nan, HUGE_VAL}) {
    EXPECT_THROW(static_cast<void>(relative_pose_error(matches, {.delta = delta})), OptionError);
  }
  EXPECT_THROW(static_cast<void>(select_pairs(matches, {.delta = 1.5, .unit = DeltaUnit::kFrames})),
               OptionError);
  EXPECT_THROW(static_cast<void>(select_pairs(matches, {.time_tolerance = nan})), OptionError);
}

TEST(RelativePoseError, SaysWhenNoPosesAreThatFarApart) {
  const auto poses = line(3);
  EXPECT_THROW(static_cast<void>(relative_pose_error(match(poses, poses))), DataError);
  EXPECT_THROW(static_cast<void>(relative_pose_error({})), DataError);
  for (const auto unit : {DeltaUnit::kFrames, DeltaUnit::kMetres}) {
    EXPECT_THROW(static_cast<void>(relative_pose_error({}, {.unit = unit})), DataError);
  }
}

}  // namespace
}  // namespace cvo_slam
