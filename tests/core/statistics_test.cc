// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "cvo_slam/core/trajectory_errors.h"

namespace cvo_slam {
namespace {

TEST(Statistics, OfFourNumbersByHand) {
  const std::vector<double> values = {4, 1, 3, 2};
  const Statistics s = summarize(values);
  EXPECT_EQ(s.count, 4U);
  EXPECT_DOUBLE_EQ(s.mean, 2.5);
  EXPECT_DOUBLE_EQ(s.median, 2.5);
  EXPECT_DOUBLE_EQ(s.sse, 30);
  EXPECT_DOUBLE_EQ(s.rmse, std::sqrt(7.5));
  EXPECT_DOUBLE_EQ(s.std, std::sqrt(1.25));
  EXPECT_DOUBLE_EQ(s.min, 1);
  EXPECT_DOUBLE_EQ(s.max, 4);
}

TEST(Statistics, MedianOfAnOddCountIsTheMiddleOne) {
  const std::vector<double> values = {9, 1, 2};
  EXPECT_DOUBLE_EQ(summarize(values).median, 2);
}

TEST(Statistics, OfNothingIsNotANumber) {
  const Statistics s = summarize(std::vector<double>{});
  EXPECT_EQ(s.count, 0U);
  for (const double figure : {s.rmse, s.mean, s.median, s.std, s.min, s.max, s.sse}) {
    EXPECT_TRUE(std::isnan(figure));
  }
}

TEST(Statistics, SpreadOfNearlyEqualNumbersDoesNotCancel) {
  // mean(x^2) - mean(x)^2 would give 0 here: 1e16 has no room for 0.25.
  const std::vector<double> values = {1e8, 1e8 + 1};
  EXPECT_DOUBLE_EQ(summarize(values).std, 0.5);
}

TEST(Statistics, ChangeUnit) {
  const std::vector<double> metres = {0.001, 0.003};
  const Statistics mm = in_unit(summarize(metres), 1000);
  EXPECT_DOUBLE_EQ(mm.mean, 2);
  EXPECT_DOUBLE_EQ(mm.sse, 10);
  EXPECT_EQ(mm.count, 2U);
}

}  // namespace
}  // namespace cvo_slam
