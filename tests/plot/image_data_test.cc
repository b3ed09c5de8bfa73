// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/plot/image_data.h"

#include <gtest/gtest.h>

namespace cvo_slam {
namespace {

TEST(Base64, IsThatOfTheStandard) {
  // The test vectors of RFC 4648, section 10.
  EXPECT_EQ(to_base64(""), "");
  EXPECT_EQ(to_base64("f"), "Zg==");
  EXPECT_EQ(to_base64("fo"), "Zm8=");
  EXPECT_EQ(to_base64("foo"), "Zm9v");
  EXPECT_EQ(to_base64("foob"), "Zm9vYg==");
  EXPECT_EQ(to_base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(to_base64("foobar"), "Zm9vYmFy");
}

TEST(Base64, TakesAnyByte) {
  EXPECT_EQ(to_base64(std::string("\xff\xfe\x00", 3)), "//4A");
  EXPECT_EQ(to_base64("\xfb"), "+w==");
}

}  // namespace
}  // namespace cvo_slam
