// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/apps/page/run_sections.h"

namespace cvo_slam {
namespace {

using testing::HasSubstr;
using testing::Not;

Figure zigzag(std::size_t points) {
  Series series;
  for (std::size_t i = 0; i < points; ++i) {
    series.x.push_back(static_cast<double>(i));
    series.y.push_back(static_cast<double>(i % 7));
  }
  Figure figure;
  figure.panels.push_back({"zigzag", "x", "y", {series}});
  return figure;
}

TEST(PagePlot, IsDrawnByItsLines) {
  const std::string html = plot(zigzag(10), "seven & back");
  EXPECT_THAT(html, HasSubstr("<div class=\"frame\"><svg "));
  EXPECT_THAT(html, HasSubstr("zigzag</text>"));
  EXPECT_THAT(html, HasSubstr("<figcaption>seven &amp; back</figcaption>"));
  EXPECT_THAT(html, Not(HasSubstr("<?xml"))) << "a page cannot have a declaration within";
}

// As vector graphics, hours of frames would make a page too large for a browser.
TEST(PagePlot, OfVeryManyPointsIsAnImage) {
  const std::string html = plot(zigzag(200'000), "hours");
  EXPECT_THAT(html, HasSubstr("src=\"data:image/png;base64,"));
  EXPECT_THAT(html, Not(HasSubstr("<svg")));
  EXPECT_LT(html.size(), 1'000'000U);
}

TEST(PagePlot, LengthsAreInTheUnitThatSuitsThem) {
  EXPECT_EQ(length_text(0.01234), "12.3 mm");
  EXPECT_EQ(length_text(4.494), "4.49 m");
  EXPECT_EQ(length_text(0), "0.0 mm");
}

}  // namespace
}  // namespace cvo_slam
