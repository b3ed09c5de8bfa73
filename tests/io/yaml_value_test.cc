// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/io/yaml_value.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/tests/io/tiny_sequence.h"

namespace cvo_slam {
namespace {

YamlValue parse(const std::string& text) { return YamlValue::parse(text, "a.yaml"); }

std::string parse_error(const std::string& text) {
  return input_error("", [&] { return parse(text); });
}

TEST(YamlValue, KnowsItsOwnLineAndThatOfItsKey) {
  const YamlValue root = parse("a: 1\nlist:\n\n  - 2\n");
  const YamlValue& list = *root.find("list");
  EXPECT_EQ(list.line(), 4);
  EXPECT_EQ(input_error("", [&]() -> int { list.fail("here"); }), "a.yaml:4: here");
  EXPECT_EQ(input_error("", [&]() -> int { list.fail_at_key("here"); }), "a.yaml:2: here");
}

TEST(YamlValue, RefusesKeysThatAreGivenTwiceAtAnyDepth) {
  EXPECT_EQ(parse_error("a: 1\na: 2\n"), "a.yaml:2: key 'a' is given twice; remove one");
  EXPECT_EQ(parse_error("list:\n  - {b: 1, b: 2}\n"),
            "a.yaml:2: key 'b' is given twice; remove one");
}

// An alias inside the value that it stands for once ended the program.
TEST(YamlValue, RefusesAValueThatContainsItself) {
  EXPECT_EQ(parse_error("a: &x [*x]\n"), "a.yaml:1: values are nested too deeply");
  EXPECT_EQ(parse_error("a: &x {b: *x}\n"), "a.yaml:1: values are nested too deeply");
}

TEST(YamlValue, AWordIsReadBackWhateverIsInIt) {
  for (const std::string text : {"plain", "odd: name # 1", "'", "\"", "~", "true", "a\nb", ""}) {
    EXPECT_EQ(parse("key: " + to_yaml_word(text) + "\n").find("key")->word("key"), text);
  }
}

}  // namespace
}  // namespace cvo_slam
