// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/loop/vocabulary.h"
#include "cvo_slam/tests/loop/descriptor_samples.h"
#include "cvo_slam/tests/temporary_folder.h"

namespace cvo_slam {
namespace {

using testing::HasSubstr;

constexpr const char* kZeros = "0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0";
constexpr const char* kOnes = "255 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 7";

std::string node_line(int parent, int is_word, const std::string& bytes, const char* weight) {
  return std::to_string(parent) + " " + std::to_string(is_word) + " " + bytes + " " + weight + "\n";
}

std::string small_text() {
  return "10 6 0 0\n" + node_line(0, 0, kZeros, "0") + node_line(1, 1, kOnes, "5.25") +
         node_line(0, 1, kOnes, "1e-2");
}

std::string problem_of(const std::string& text) {
  try {
    static_cast<void>(vocabulary_from_text(text, "words.txt"));
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST(VocabularyText, ReadsTheFormatOfOrbSlam) {
  const Vocabulary vocabulary = vocabulary_from_text(small_text(), "words.txt");
  EXPECT_EQ(vocabulary.branching(), 10);
  EXPECT_EQ(vocabulary.levels(), 6);
  EXPECT_EQ(vocabulary.words(), 2U);
  const auto nodes = vocabulary.tree();
  EXPECT_FLOAT_EQ(nodes[1].weight, 0.01F);
  EXPECT_EQ(nodes[2].parent, 1U);
  EXPECT_FLOAT_EQ(nodes[2].weight, 5.25F);
  EXPECT_EQ(to_bytes(nodes[2].descriptor)[0], 255);
  EXPECT_EQ(to_bytes(nodes[2].descriptor)[31], 7);
}

/// ORB-SLAM2's loader reads the newline at the end of its own file as one more node, of zeros.
TEST(VocabularyText, LineEndsMayBeAnyOrMissing) {
  const std::size_t nodes = vocabulary_from_text(small_text(), "words.txt").nodes();
  std::string text = small_text();
  EXPECT_EQ(vocabulary_from_text(text + "\n \n", "words.txt").nodes(), nodes);
  text.pop_back();
  EXPECT_EQ(vocabulary_from_text(text, "words.txt").nodes(), nodes);
  std::string dos;
  for (const char c : small_text()) dos += c == '\n' ? std::string(" \r\n") : std::string(1, c);
  EXPECT_EQ(vocabulary_from_text(dos, "words.txt").nodes(), nodes);
}

TEST(VocabularyText, MistakesAreReportedWithTheirLine) {
  EXPECT_THAT(problem_of(""), HasSubstr("is empty"));
  EXPECT_THAT(problem_of("10 6 1 0\n"), HasSubstr("words.txt:1: the scoring"));
  EXPECT_THAT(problem_of("10 6 0 3\n"), HasSubstr("words.txt:1: the weighting"));
  EXPECT_THAT(problem_of("1 6 0 0\n"), HasSubstr("the branching is 1"));
  EXPECT_THAT(problem_of("10 six 0 0\n"), HasSubstr("the number of levels is missing"));
  EXPECT_THAT(problem_of("10 6 0 0\n"), HasSubstr("no words"));
  const std::string head = "10 6 0 0\n" + node_line(0, 1, kZeros, "1");
  EXPECT_THAT(problem_of(head + node_line(2, 1, kZeros, "1")),
              HasSubstr("words.txt:3: the parent is 2"));
  EXPECT_THAT(problem_of(head + node_line(0, 2, kZeros, "1")), HasSubstr("words.txt:3: is_word"));
  EXPECT_THAT(problem_of(head + "0 1 256"), HasSubstr("words.txt:3: a byte of the descriptor"));
  EXPECT_THAT(problem_of(head + node_line(0, 1, kZeros, "1 2")),
              HasSubstr("words.txt:3: has more numbers"));
  EXPECT_THAT(problem_of(head + node_line(0, 1, kZeros, "nan")), HasSubstr("weight nan"));
  EXPECT_THAT(problem_of(head + node_line(0, 1, kZeros, "x")), HasSubstr("weight is missing"));
}

// DBoW2 writes weights as doubles.
TEST(VocabularyText, AWeightThatIsTooSmallForAFloatIsZero) {
  for (const char* weight : {"1e-60", "4.94e-320"}) {
    const auto vocabulary =
        vocabulary_from_text("10 6 0 0\n" + node_line(0, 1, kZeros, weight), "words.txt");
    EXPECT_EQ(vocabulary.weight(0), 0) << weight;
  }
  EXPECT_THAT(problem_of("10 6 0 0\n" + node_line(0, 1, kZeros, "1e60")),
              HasSubstr("words.txt:2: the weight is 1e60, which is too large"));
}

TEST(VocabularyText, TruncationIsFound) {
  // In the middle of a line, and before all children of a node. The format has no other check.
  const std::string text = small_text();
  EXPECT_THAT(problem_of(text.substr(0, text.size() - 20)), HasSubstr("words.txt:4: "));
  EXPECT_THAT(problem_of("10 6 0 0\n" + node_line(0, 0, kZeros, "0")),
              HasSubstr("no word and has no children; is the file cut off?"));
}

TEST(VocabularyText, ReadsBackWhatWasWritten) {
  const TemporaryFolder folder;
  const Vocabulary vocabulary(3, 4, full_tree(3, 4, 9));
  write_vocabulary_text(folder.path() / "words.txt", vocabulary);
  EXPECT_EQ(vocabulary_bytes(read_vocabulary(folder.path() / "words.txt")),
            vocabulary_bytes(vocabulary));
  EXPECT_THROW(write_vocabulary_text(folder.path() / "no" / "folder.txt", vocabulary), OutputError);
}

/// A tree of the size of ORB-SLAM's file: 1.1 million nodes, 150 MB of text.
TEST(VocabularyText, TakesAFileOfTheSizeOfOrbSlams) {
  const TemporaryFolder folder;
  const auto text = folder.path() / "words.txt";
  const auto binary = folder.path() / "words.voc";
  std::string bytes;
  {
    const Vocabulary vocabulary(10, 6, full_tree(10, 6, 3));
    bytes = vocabulary_bytes(vocabulary);
    write_vocabulary_text(text, vocabulary);
  }
  EXPECT_GT(std::filesystem::file_size(text), 130'000'000U);
  const Vocabulary read = read_vocabulary(text);
  EXPECT_EQ(read.words(), 1'000'000U);
  EXPECT_TRUE(vocabulary_bytes(read) == bytes);
  write_vocabulary(binary, read);
  EXPECT_TRUE(vocabulary_bytes(read_vocabulary(binary)) == bytes);
}

}  // namespace
}  // namespace cvo_slam
