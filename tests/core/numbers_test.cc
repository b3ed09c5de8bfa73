// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/core/numbers.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include <gtest/gtest.h>

namespace cvo_slam {
namespace {

TEST(ParseNumber, TakesTheNumbersOfOtherPrograms) {
  EXPECT_EQ(parse_number("+0.5"), 0.5);
  EXPECT_EQ(parse_number("-1e3"), -1000.0);
  EXPECT_EQ(parse_number("5."), 5.0);
  EXPECT_EQ(parse_number(".5"), 0.5);
  for (const char* nothing : {"", "+", "-", "+-1", "++1", "1x", "0x10", "1 ", "one", "1e", "."}) {
    EXPECT_FALSE(parse_number(nothing)) << nothing;
  }
}

TEST(ParseNumber, WhatIsTooSmallIsZeroAndWhatIsTooLargeIsInfinite) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const std::string& small :
       {std::string("1e-400"), std::string("+1e-99999999999999999999"),
        std::string("0e999999999999"), "0." + std::string(400, '0') + "1",
        "0." + std::string(800, '0') + "1e300"}) {
    EXPECT_EQ(parse_finite(small), 0.0) << small;
  }
  EXPECT_EQ(parse_number("-1e-400"), 0.0);
  for (const std::string& large : {std::string("1e400"), std::string("1e99999999999999999999"),
                                   std::string(400, '9'), std::string(800, '9') + "e-300"}) {
    EXPECT_EQ(parse_number(large), kInfinity) << large;
    EXPECT_FALSE(parse_finite(large)) << large;
  }
  EXPECT_EQ(parse_number("-1e400"), -kInfinity);
  EXPECT_TRUE(std::isnan(*parse_number("NaN")));
  EXPECT_EQ(parse_number("-inf"), -kInfinity);
}

TEST(ParseInteger, TakesTheWholeTextOrNothing) {
  EXPECT_EQ(parse_integer<int>("-12"), -12);
  EXPECT_EQ(parse_integer<std::uint8_t>("255"), 255);
  for (const char* nothing : {"", "256", "-1", "1.0", "1 ", "0x1"}) {
    EXPECT_FALSE(parse_integer<std::uint8_t>(nothing)) << nothing;
  }
}

}  // namespace
}  // namespace cvo_slam
