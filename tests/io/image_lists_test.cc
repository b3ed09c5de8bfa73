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

TEST(CameraNamedBy, KnowsTheNamesOfPublishedSequences) {
  EXPECT_EQ(camera_named_by("rgbd_dataset_freiburg1_rpy"), "tum_fr1");
  EXPECT_EQ(camera_named_by("fr2_desk"), "tum_fr2");
  EXPECT_EQ(camera_named_by("TUM-fr3-office"), "tum_fr3");
  EXPECT_EQ(camera_named_by("living_room_traj2_frei_png"), "icl_nuim");
  EXPECT_EQ(camera_named_by("traj0_frei_png"), "icl_nuim");
  EXPECT_EQ(camera_named_by("icl_office_kt3"), "icl_nuim");
  for (const char* name : {"fr10", "afr1", "office", "bicl", "room", ""}) {
    EXPECT_EQ(camera_named_by(name), std::nullopt) << name;
  }
}

}  // namespace
}  // namespace cvo_slam
