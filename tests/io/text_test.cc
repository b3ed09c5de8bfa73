// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/io/text_internal.h"
#include "cvo_slam/tests/io/tiny_sequence.h"

namespace cvo_slam {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string stamp_error(const std::string& word) {
  return input_error("", [&] { return parse_stamp({3, {word}}, 0, "a.txt"); });
}

TEST(NumberProblem, NamesDecimalCommas) {
  EXPECT_EQ(number_problem("0,5"), "'0,5' has a decimal comma; write numbers with a point");
  EXPECT_EQ(number_problem("1,2,3"), "'1,2,3' is not a finite number; repair or remove the line");
  EXPECT_EQ(number_problem("nan"), "'nan' is not a finite number; repair or remove the line");
}

// A picture that was given as a list put its bytes on the terminal.
TEST(InQuotes, IsShortAndPrintable) {
  EXPECT_EQ(in_quotes("\x89PNG\r\n\x1a"),
            "'?PNG??"
            "?'");
  EXPECT_EQ(in_quotes(std::string(100, 'a')), "'" + std::string(40, 'a') + "...'");
}

TEST(SplitColumns, SeparatesAtBlanksCommasOrSemicolons) {
  EXPECT_THAT(split_columns(" 1 \t2\r"), ElementsAre("1", "2"));
  EXPECT_THAT(split_columns("1,2, 3 ,4\r"), ElementsAre("1", "2", "3", "4"));
  EXPECT_THAT(split_columns("1;2;"), ElementsAre("1", "2"));
  EXPECT_THAT(split_columns("1,,3"), ElementsAre("1", "", "3"));
  EXPECT_THAT(split_columns(","), ElementsAre(""));
}

TEST(SplitColumns, LeavesCommasInsideWordsAlone) {
  EXPECT_THAT(split_columns("1.0 rgb/a,b;c.png"), ElementsAre("1.0", "rgb/a,b;c.png"));
  EXPECT_THAT(split_columns("0,5 1,5 2,5"), ElementsAre("0,5", "1,5", "2,5"));
  EXPECT_THAT(split_columns("0,5;1,5"), ElementsAre("0,5", "1,5"));
}

TEST(ReadWordLines, SkipsCommentsBlankLinesAndTheByteOrderMark) {
  const TemporaryFolder folder;
  const auto lines =
      read_word_lines(folder.write("a.txt", "\xEF\xBB\xBF# c\n\n \t\r\n #c\n1,2\r\n3 4"));
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0].number, 5);
  EXPECT_THAT(lines[0].words, ElementsAre("1", "2"));
  EXPECT_THAT(lines[1].words, ElementsAre("3", "4"));
}

// "is not a time stamp in seconds" left the user to find out why.
TEST(ParseStamp, NamesTheUnitOfAStampThatIsNotInSeconds) {
  EXPECT_EQ(stamp_error("1305031102175.3"),
            "a.txt:3: '1305031102175.3' is a time in milliseconds, and stamps are in seconds; "
            "divide those of this file by 1000");
  EXPECT_THAT(stamp_error("1305031102175304"), HasSubstr("in microseconds"));
  EXPECT_THAT(stamp_error("1305031102175304031"), HasSubstr("in nanoseconds"));
  EXPECT_THAT(stamp_error("1305031102175304031"), HasSubstr("by 1000000000"));
  EXPECT_THAT(stamp_error("1.305031102175304031e+18"), HasSubstr("in nanoseconds"));
  EXPECT_THAT(stamp_error("9000000000"), HasSubstr("after the year 2096"));
  EXPECT_EQ(stamp_error("1305031102"), "no error");
  EXPECT_EQ(stamp_error("+1305031102.5"), "no error");
}

TEST(ParseStamp, SaysWhatToDoWithOtherWords) {
  EXPECT_EQ(stamp_error("0,5"), "a.txt:3: '0,5' has a decimal comma; write stamps with a point");
  EXPECT_EQ(stamp_error("time"),
            "a.txt:3: 'time' is not a time stamp in seconds; repair or remove the line, or begin "
            "it with '#' if it is a heading");
}

}  // namespace
}  // namespace cvo_slam
