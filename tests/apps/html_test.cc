// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/page/html.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cvo_slam::html {
namespace {

using testing::HasSubstr;
using testing::Not;

const std::string kUnknown = "\xEF\xBF\xBD";  // U+FFFD

TEST(Html, TextCannotBecomeMarkup) {
  EXPECT_EQ(escaped(R"(<b a="1" c='2'> & </b>)"),
            "&lt;b a=&quot;1&quot; c=&#39;2&#39;&gt; &amp; &lt;/b&gt;");
  EXPECT_EQ(escaped(std::string("a\0b\x1B\x7F\n", 6)),
            "a" + kUnknown + "b" + kUnknown + kUnknown + "\n");
}

TEST(Html, TextIsUtf8WhateverComes) {
  EXPECT_EQ(escaped("Z\xC3\xBCrich \xE2\x80\xA6 \xF0\x9F\x98\x80"),
            "Z\xC3\xBCrich \xE2\x80\xA6 \xF0\x9F\x98\x80");
  EXPECT_EQ(escaped("Z\xFCrich"), "Z" + kUnknown + "rich") << "Latin-1";
  EXPECT_EQ(escaped("\xE2\x80"), kUnknown + kUnknown) << "cut off";
  EXPECT_EQ(escaped("\xC0\xBC"), kUnknown + kUnknown) << "'<' in more bytes than needed";
  EXPECT_EQ(escaped("\xED\xA0\x80"), kUnknown + kUnknown + kUnknown) << "a surrogate";
  EXPECT_EQ(escaped("\xF4\x90\x80\x80"), kUnknown + kUnknown + kUnknown + kUnknown) << "U+110000";
}

TEST(Html, FilesBecomePartOfThePage) {
  EXPECT_EQ(data_uri("image/png", "abc"), "data:image/png;base64,YWJj");
  const std::string image = jpeg_image(cv::Mat(8, 8, CV_8UC3, cv::Scalar::all(9)), "\"dark\"");
  EXPECT_THAT(image, HasSubstr("alt=\"&quot;dark&quot;\""));
  EXPECT_THAT(image, HasSubstr("src=\"data:image/jpeg;base64,/9j/"))
      << "a JPEG begins with FF D8 FF";
}

TEST(Html, TablesEscapeTheirCells) {
  Table table({{"<name>"}, {"value", Cell::kNumber}});
  EXPECT_TRUE(table.empty());
  table.add({"<script>", "1"});
  EXPECT_FALSE(table.empty());
  EXPECT_THAT(table.content(), HasSubstr("<td>&lt;script&gt;</td><td class=\"number\">1</td>"));
  EXPECT_THAT(table.content(), HasSubstr("&lt;name&gt;</th>"));
  EXPECT_THAT(table.content(), Not(HasSubstr("<script>")));
}

TEST(Html, SectionsAndFiguresEscapeTheirTexts) {
  EXPECT_THAT(section("a", "<", "<p></p>"), HasSubstr("<h2>&lt;</h2>\n<p></p>"));
  EXPECT_THAT(figure("<img>", "<"), HasSubstr("<img></div>\n<figcaption>&lt;</figcaption>"));
  EXPECT_EQ(paragraph("<"), "<p>&lt;</p>\n");
}

}  // namespace
}  // namespace cvo_slam::html
