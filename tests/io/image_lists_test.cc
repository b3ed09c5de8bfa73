// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdint>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/io/dataset/image_lists_internal.h"

namespace cvo_slam {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

std::vector<Timestamp> milliseconds(const std::vector<std::int64_t>& values) {
  std::vector<Timestamp> stamps;
  stamps.reserve(values.size());
  for (const auto value : values) stamps.emplace_back(value * 1000000);
  return stamps;
}

TEST(AssociateStamps, PairsTheNearest) {
  EXPECT_THAT(associate_stamps(milliseconds({0, 33, 66}), milliseconds({5, 30, 70}), 0.02),
              ElementsAre(Pair(0, 0), Pair(1, 1), Pair(2, 2)));
}

TEST(AssociateStamps, TheClosestPairOfAllGoesFirst) {
  // 10 is the nearest of both 0 and 12; 12 is closer and gets it, 0 takes what is left.
  EXPECT_THAT(associate_stamps(milliseconds({0, 12}), milliseconds({-15, 10}), 0.02),
              ElementsAre(Pair(0, 0), Pair(1, 1)));
  EXPECT_THAT(associate_stamps(milliseconds({0, 12}), milliseconds({10}), 0.02),
              ElementsAre(Pair(1, 0)));
}

TEST(AssociateStamps, TheEarlierOfEqualDifferencesGoesFirst) {
  EXPECT_THAT(associate_stamps(milliseconds({0, 20}), milliseconds({10}), 0.02),
              ElementsAre(Pair(0, 0)));
}

TEST(AssociateStamps, TheLimitIsInclusive) {
  EXPECT_THAT(associate_stamps(milliseconds({0}), milliseconds({20}), 0.02),
              ElementsAre(Pair(0, 0)));
  EXPECT_THAT(associate_stamps(milliseconds({0}), milliseconds({21}), 0.02), IsEmpty());
  EXPECT_THAT(associate_stamps(milliseconds({0}), {}, 0.02), IsEmpty());
}

}  // namespace
}  // namespace cvo_slam
