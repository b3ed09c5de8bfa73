// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <functional>
#include <numbers>
#include <tuple>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/frontend/tracker.h"
#include "cvo_slam/frontend/tracking_doubt_internal.h"
#include "cvo_slam/frontend/tracking_judgement_internal.h"
#include "cvo_slam/tests/frontend/synthetic_frames.h"
#include "cvo_slam/tests/frontend/test_frames.h"

namespace cvo_slam {
namespace {

/// A frame like most at 30 Hz.
DoubtEvidence usual_evidence() {
  return {.overlap = 0.9,
          .relative_cos_theta = 1,
          .sigma = 0.001,
          .surprise = 0.002,
          .seconds = 1 / 30.0};
}

double doubt_after(const std::function<void(DoubtEvidence&)>& change) {
  DoubtEvidence evidence = usual_evidence();
  change(evidence);
  return doubt_of(evidence);
}

TEST(Doubt, IsSmallForAUsualFrame) { EXPECT_LT(doubt_of(usual_evidence()), 0.003); }

TEST(Doubt, GrowsWithWhatSpeaksAgainstAFrame) {
  const double usual = doubt_of(usual_evidence());
  EXPECT_GT(doubt_after([](auto& e) { e.overlap = 0.4; }), usual);
  EXPECT_GT(doubt_after([](auto& e) { e.relative_cos_theta = 0.4; }), usual);
  EXPECT_GT(doubt_after([](auto& e) { e.surprise = 0.2; }), usual);
  EXPECT_GT(doubt_after([](auto& e) { e.rival = 0.8; }), usual);
  EXPECT_GT(doubt_after([](auto& e) { e.features = FeatureOpinion::kElsewhere; }), usual);
  EXPECT_LT(doubt_after([](auto& e) { e.features = FeatureOpinion::kAgrees; }), usual);
  EXPECT_GT(doubt_after([](auto& e) {
              e.overlap = 0.3;
              e.relative_cos_theta = 0.3;
              e.surprise = 0.3;
              e.seconds = 0.5;
            }),
            0.9);
}

TEST(Doubt, ARivalIsElsewhereBeyondWhatTheCovariancesExplain) {
  const Matrix6 certain = 1e-6 * Matrix6::Identity();
  const Matrix6 uncertain = 1e-2 * Matrix6::Identity();
  const SE3 near(so3_exp({0, 0.05, 0}), {0.05, 0, 0});
  const SE3 far(so3_exp({0, 0, 0}), {0.07, 0, 0});
  EXPECT_FALSE(are_apart(SE3(), certain, near, certain));
  EXPECT_TRUE(are_apart(SE3(), certain, far, certain));
  EXPECT_TRUE(are_apart(SE3(), certain, SE3(so3_exp({0, 0.07, 0}), {0, 0, 0}), certain));
  EXPECT_FALSE(are_apart(SE3(), certain, far, uncertain)) << "a wall along which nothing holds it";
  // What is open along the second camera's view does not explain a quarter turn.
  Matrix6 along_z = certain;
  along_z(2, 2) = 1;
  const SE3 turned(so3_exp({0, std::numbers::pi / 2, 0}), {0, 0, 0.5});
  EXPECT_TRUE(are_apart(SE3(), certain, turned, along_z));
}

TEST(Doubt, AnEqualRivalIsBelievedAsSimilarAndFarAway) {
  RegistrationResult result;
  result.cos_theta = 0.5;
  result.covariance = 1e-6 * Matrix6::Identity();
  const Answer rival = {SE3(so3_exp({0, 0.02, 0}), {0.3, 0, 0.4}), result.covariance, 0.49, true};
  EXPECT_TRUE(is_equal_rival(rival, result));
  const auto is_one_after = [&](const std::function<void(Answer&)>& change) {
    Answer changed = rival;
    change(changed);
    return is_equal_rival(changed, result);
  };
  EXPECT_FALSE(is_one_after([](Answer& a) { a.is_believed = false; }));
  EXPECT_FALSE(is_one_after([](Answer& a) { a.cos_theta = 0.45; }));
  EXPECT_FALSE(is_one_after([](Answer& a) { a.covariance = 0.1 * Matrix6::Identity(); }));
  EXPECT_FALSE(is_one_after([](Answer& a) {
    a.T_fixed_moving = SE3(so3_exp({0, 0.02, 0}), {0.08, 0, 0});
  })) << "not worth a frame";
  EXPECT_TRUE(is_one_after([](Answer& a) {
    a.T_fixed_moving = SE3(so3_exp({0, 0.1, 0}), {0, 0, 0});
  }));
}

TEST(Doubt, TheUsualSimilarityIsThatOfTheLastFrames) {
  UsualSimilarity usual;
  EXPECT_EQ(usual.share(0.3), 1) << "nothing is known yet";
  usual.add(0.6);
  EXPECT_DOUBLE_EQ(usual.share(0.3), 0.5);
  for (int i = 0; i < 1000; ++i) usual.add(0.3);
  EXPECT_NEAR(usual.share(0.3), 1, 1e-3);
}

TEST(Doubt, EvidenceIsTakenFromTheResult) {
  RegistrationResult result;
  result.overlap = 0.7;
  result.cos_theta = 0.2;
  result.covariance.diagonal() << 1e-6, 4e-6, 9e-6, 1e-8, 4e-8, 1e-8;
  const SE3 T_predicted_camera(so3_exp({0, 0.1, 0}), {0.03, 0, 0.04});
  const DoubtEvidence evidence =
      evidence_of(result, surprise_of(T_predicted_camera), 0.2, UsualSimilarity());
  EXPECT_EQ(evidence.overlap, 0.7);
  EXPECT_EQ(evidence.relative_cos_theta, 1);
  EXPECT_NEAR(evidence.sigma, 3e-3, 1e-9);
  EXPECT_NEAR(evidence.surprise, 0.1, 1e-9) << "the angle";
  EXPECT_EQ(evidence.seconds, 0.2);
  EXPECT_EQ(evidence.features, FeatureOpinion::kNone);
}

TEST(Doubt, IsInTheRecordAndDecides) {
  const SyntheticFrames frames{small_camera(320, 240)};
  TrackerOptions options;
  Tracker tracker(frames.camera(), options);
  for (std::size_t i = 0; i < 5; ++i) {
    const FrameRecord record = tracker.track(frames.frame(i)).record;
    EXPECT_EQ(record.status, TrackingStatus::kTracked);
    EXPECT_LT(record.doubt, 0.02) << i;
  }
  options.lost.max_doubt = 0;
  Tracker strict(frames.camera(), options);
  std::ignore = strict.track(frames.frame(0));
  const FrameRecord record = strict.track(frames.frame(1)).record;
  EXPECT_EQ(record.status, TrackingStatus::kLost);
  EXPECT_THAT(record.reason, testing::HasSubstr("wrong by more than 5 cm or 3 degrees"));
  EXPECT_GT(record.doubt, 0);
}

}  // namespace
}  // namespace cvo_slam
