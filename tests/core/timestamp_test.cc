// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/core/timestamp.h"

#include <gtest/gtest.h>

namespace cvo_slam {
namespace {

TEST(Timestamp, IsWrittenBackWithTheSameDigits) {
  for (const char* text : {"1305031229.528748", "1305031225.9334", "1", "0.000000001", "-3.25",
                           "1305031229.500000", "-0.5"}) {
    const auto stamp = Timestamp::parse(text);
    ASSERT_TRUE(stamp) << text;
    EXPECT_EQ(stamp->to_string(), text);
  }
}

TEST(Timestamp, ReadsNanosecondsExactly) {
  EXPECT_EQ(Timestamp::parse("1305031229.528748")->nanoseconds(), 1305031229528748000);
  EXPECT_EQ(Timestamp::parse("-3.25")->nanoseconds(), -3250000000);
  EXPECT_EQ(Timestamp::parse("1.0000000005")->nanoseconds(), 1000000001);
  EXPECT_EQ(Timestamp::parse("1.9999999999")->nanoseconds(), 2000000000);
  EXPECT_EQ(Timestamp::parse("1.305031102160407066e+09")->nanoseconds(), 1305031102160407066);
  EXPECT_EQ(Timestamp::parse("+1.5")->nanoseconds(), 1500000000);
  EXPECT_EQ(Timestamp::parse("1e-400")->nanoseconds(), 0);
}

TEST(Timestamp, RejectsWhatIsNoTime) {
  for (const char* text : {"", "-", "abc", "nan", "inf", "1e400", "1.2.3", "12x", "1 2", ".5",
                           "99999999999999999999", "+", "+-1", "++1"}) {
    EXPECT_FALSE(Timestamp::parse(text)) << text;
  }
}

TEST(Timestamp, ComparesTimeNotDigits) {
  EXPECT_EQ(*Timestamp::parse("1.5"), *Timestamp::parse("1.500"));
  EXPECT_LT(*Timestamp::parse("1.5"), *Timestamp::parse("1.500001"));
  EXPECT_DOUBLE_EQ(seconds_between(*Timestamp::parse("1.5"), *Timestamp::parse("1.75")), 0.25);
}

}  // namespace
}  // namespace cvo_slam
