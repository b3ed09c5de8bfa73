// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstddef>
#include <random>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/slam/proximity_internal.h"

namespace cvo_slam {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(ProximityIndex, ListsTheOthersWithinBothReachesNewestFirst) {
  ProximityIndex index;
  index.set(0, {0, 0, 0}, 1);
  index.set(1, {1.9, 0, 0}, 1);
  index.set(2, {0, -2.9, 0}, 2);
  index.set(3, {0, 0, 3.1}, 2);
  EXPECT_THAT(index.within_reach_of(0), ElementsAre(2, 1));
  index.set(3, {0, 0, 2.9}, 2);
  EXPECT_THAT(index.within_reach_of(0), ElementsAre(3, 2, 1)) << "it was moved";
  index.set(3, {100, 0, 0}, 2);
  EXPECT_THAT(index.within_reach_of(3), IsEmpty());
}

TEST(ProximityIndex, ARemovedKeyframeIsForgottenAndLaterOnesMoveUp) {
  ProximityIndex index;
  for (std::size_t i = 0; i < 4; ++i) index.set(i, {0.1 * static_cast<double>(i), 0, 0}, 1);
  index.remove(1);
  EXPECT_THAT(index.within_reach_of(0), ElementsAre(2, 1));
  index.set(2, {100, 0, 0}, 1);  // the last one
  EXPECT_THAT(index.within_reach_of(0), ElementsAre(1));
}

TEST(ProximityIndex, FindsWhatAFullSearchFinds) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-15, 15);
  std::uniform_real_distribution<double> reach(0.5, 7);
  ProximityIndex index;
  std::vector<Vector3> cameras;
  std::vector<double> reaches;
  for (std::size_t i = 0; i < 300; ++i) {
    cameras.emplace_back(coordinate(random), coordinate(random), coordinate(random));
    reaches.push_back(reach(random));
    index.set(i, cameras.back(), reaches.back());
  }
  for (const std::size_t center : {0U, 17U, 299U}) {
    std::vector<std::size_t> expected;
    for (std::size_t i = cameras.size(); i-- > 0;) {
      const double distance = (cameras[i] - cameras[center]).norm();
      if (i != center && distance <= reaches[i] + reaches[center]) expected.push_back(i);
    }
    EXPECT_EQ(index.within_reach_of(center), expected);
  }
}

}  // namespace
}  // namespace cvo_slam
