// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/io/yaml_value.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/core/error.h"
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

// An alias inside the value that it stands for overflowed the stack, and aliases of aliases, each
// twice as large as the one before, filled the memory.
TEST(YamlValue, RefusesAnchorsAndAliases) {
  const std::string problem = "the anchor '&x' is not supported; write the value where it is used";
  EXPECT_EQ(parse_error("a: &x [*x]\n"), "a.yaml:1: " + problem);
  EXPECT_EQ(parse_error("a: 1\nb: &x {b: *x}\n"), "a.yaml:2: " + problem);
  EXPECT_EQ(parse_error("a: &x\n"), "a.yaml:1: " + problem);
  EXPECT_EQ(parse_error("a: 1\n&x b: 1\n"), "a.yaml:2: " + problem);
  EXPECT_THAT(parse_error("a: *x\n"), testing::HasSubstr("a.yaml:1: not valid YAML"));
}

TEST(YamlValue, RefusesDeepNesting) {
  const std::string problem = "values are nested too deeply; 32 levels are possible";
  for (const std::size_t levels : {32U, 10000U, 1000000U}) {
    const std::string closed = std::string(levels, '[') + std::string(levels, ']');
    EXPECT_EQ(parse_error("a: " + closed + "\n"), "a.yaml:1: " + problem);
    // Cut off, they may be keys; what counts is that the stack holds.
    EXPECT_THAT(parse_error("a: " + std::string(levels, '[')), testing::HasSubstr("a.yaml:1: "));
    EXPECT_THAT(parse_error("a: " + std::string(levels, '{')), testing::HasSubstr("a.yaml:1: "));
  }
  std::string lists;
  for (int i = 0; i < 100000; ++i) lists += "- ";
  EXPECT_EQ(parse_error("a:\n  " + lists + "1\n"), "a.yaml:2: " + problem);
  std::string keys;
  for (int i = 0; i < 40; ++i) keys += std::string(static_cast<std::size_t>(i), ' ') + "a:\n";
  EXPECT_EQ(parse_error(keys), "a.yaml:33: " + problem);
  const std::string thirty(30, '[');
  EXPECT_EQ(parse_error("a: " + thirty + std::string(30, ']')), "no error");
}

TEST(YamlValue, NamesASecondDocument) {
  const std::string problem = "a second document begins before this ('---'); keep one in the file";
  EXPECT_EQ(parse_error("a: 1\n---\nb: 2\n"), "a.yaml:3: " + problem);
  EXPECT_EQ(parse_error("---\n---\nb: 2\n"), "a.yaml:3: " + problem);
  EXPECT_EQ(parse_error("%YAML:1.0\n---\na: 1\n...\n"), "no error");
  EXPECT_EQ(parse_error("a: 1\n---\n"), "no error");
}

TEST(YamlValue, SkipsAByteOrderMarkAndNamesUtf16) {
  EXPECT_EQ(parse("\xEF\xBB\xBF%YAML:1.0\na: +0.5\n").find("a")->number("a"), 0.5);
  EXPECT_EQ(parse_error(std::string("a\0:\0", 4)), "a.yaml: is UTF-16 text; save it as UTF-8");
}

TEST(YamlValue, NamesADecimalComma) {
  const YamlValue root = parse("fx: 517,3\n");
  EXPECT_EQ(input_error("", [&] { return root.find("fx")->number("fx"); }),
            "a.yaml:1: fx: '517,3' has a decimal comma; write numbers with a point");
}

TEST(YamlValue, EmptyFilesAndValuesAreEmpty) {
  EXPECT_TRUE(parse("").is_empty());
  EXPECT_TRUE(parse("# nothing\n").is_empty());
  EXPECT_TRUE(parse("---\n").is_empty());
  const YamlValue root = parse("a: 1\nb:\nc: ~\nd: [~, 2]\n");
  EXPECT_TRUE(root.find("b")->is_empty());
  EXPECT_EQ(root.find("b")->line(), 2);
  EXPECT_TRUE(root.find("c")->is_empty());
  EXPECT_EQ(root.find("d")->list("d").size(), 2U);
  EXPECT_EQ(parse_error("1\n"), "a.yaml:1: expected 'key: value' lines");
  EXPECT_EQ(parse_error("~: 1\n"), "a.yaml:1: a key must be a plain word");
  EXPECT_EQ(parse_error("[a]: 1\n"), "a.yaml:1: a key must be a plain word");
}

TEST(YamlValue, AWordIsReadBackWhateverIsInIt) {
  for (const std::string text : {"plain", "odd: name # 1", "'", "\"", "~", "true", "a\nb", ""}) {
    EXPECT_EQ(parse("key: " + to_yaml_word(text) + "\n").find("key")->word("key"), text);
  }
}

TEST(YamlValue, BytesThatAreNoTextAreRefused) {
  for (const char* text : {"a: 1\nkey\xff\xff: 2\n", "a: 1\nb: \x04\n", "a: 1\n\x7f: 1\n"}) {
    EXPECT_THAT(
        [&] { static_cast<void>(YamlValue::parse(text, "file.yaml")); },
        testing::ThrowsMessage<InputError>(testing::HasSubstr("file.yaml:2: has bytes that are")))
        << text;
  }
}

// The fuzzer found it: yaml-cpp read on without an end.
TEST(YamlValue, ACommaOutsideOfAnyValueIsRefused) {
  EXPECT_THROW(static_cast<void>(YamlValue::parse(",YAM", "file.yaml")), InputError);
}

}  // namespace
}  // namespace cvo_slam
