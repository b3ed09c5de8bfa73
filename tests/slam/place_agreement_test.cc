// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "cvo_slam/slam/place_agreement_internal.h"

namespace cvo_slam {
namespace {

constexpr double kMaxSpeed = 3;         // [m/s]
constexpr double kMaxAngularSpeed = 6;  // [rad/s]

PlaceGuess guess(double seconds, double x, int part = 0) {
  return {Timestamp::from_seconds(100 + seconds), part, SE3(Matrix3::Identity(), {x, 0, 0})};
}

TEST(PlaceAgreement, ThreeOnOneWayAgree) {
  PlaceAgreement agreement(3, kMaxSpeed, kMaxAngularSpeed);
  EXPECT_FALSE(agreement.see(guess(0, 1)));
  EXPECT_FALSE(agreement.see(guess(0.033, 1.05)));
  EXPECT_TRUE(agreement.see(guess(0.1, 1.2)));
}

TEST(PlaceAgreement, AnotherPlaceStartsAgain) {
  PlaceAgreement agreement(3, kMaxSpeed, kMaxAngularSpeed);
  EXPECT_FALSE(agreement.see(guess(0, 1)));
  EXPECT_FALSE(agreement.see(guess(0.033, 1)));
  EXPECT_FALSE(agreement.see(guess(0.066, 7)));
  EXPECT_EQ(agreement.count(), 1);
  EXPECT_FALSE(agreement.see(guess(0.1, 7, 2))) << "in another part's world";
  EXPECT_EQ(agreement.count(), 1);
}

TEST(PlaceAgreement, OldOnesSayNothing) {
  PlaceAgreement agreement(2, kMaxSpeed, kMaxAngularSpeed);
  EXPECT_FALSE(agreement.see(guess(0, 1)));
  EXPECT_FALSE(agreement.see(guess(1, 1)));
}

TEST(PlaceAgreement, CanForget) {
  PlaceAgreement agreement(2, kMaxSpeed, kMaxAngularSpeed);
  EXPECT_FALSE(agreement.see(guess(0, 1)));
  agreement.forget();
  EXPECT_FALSE(agreement.see(guess(0.033, 1)));
}

}  // namespace
}  // namespace cvo_slam
