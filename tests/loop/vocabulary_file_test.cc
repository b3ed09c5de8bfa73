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

using testing::AllOf;
using testing::HasSubstr;

class VocabularyFile : public testing::Test {
 protected:
  /// Returns the error message of reading these bytes.
  [[nodiscard]] std::string problem_of(const std::string& bytes) const {
    const auto file = folder_.write("words.voc", bytes);
    try {
      static_cast<void>(read_vocabulary(file));
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("words.voc: "));
      return error.what();
    }
    return "none";
  }

  /// Returns the error message, with a line, of reading this text.
  [[nodiscard]] std::string text_problem(const std::string& text) const {
    try {
      static_cast<void>(read_vocabulary(folder_.write("words.voc", text)));
    } catch (const InputError& error) {
      return error.what();
    }
    return "none";
  }

  TemporaryFolder folder_;
  Vocabulary vocabulary_{3, 3, full_tree(3, 3, 1)};
  std::string bytes_ = vocabulary_bytes(vocabulary_);
};

TEST_F(VocabularyFile, ReadsBackWhatWasWritten) {
  const auto file = folder_.path() / "words.voc";
  write_vocabulary(file, vocabulary_);
  const Vocabulary read = read_vocabulary(file);
  EXPECT_EQ(read.branching(), 3);
  EXPECT_EQ(read.levels(), 3);
  EXPECT_EQ(read.words(), 27U);
  EXPECT_EQ(read.tree(), vocabulary_.tree());
  EXPECT_EQ(vocabulary_bytes(read), bytes_);
}

TEST_F(VocabularyFile, HasTheLayoutThatIsDocumented) {
  EXPECT_EQ(bytes_.size(), 40U + 40 + 39 * 32 + 27 * 4);
  EXPECT_EQ(bytes_.substr(0, 12), std::string("cvo-voc\n\1\0\0\0", 12));
  EXPECT_EQ(bytes_.substr(40, 14), std::string(13, '\3') + '\0');
  const DescriptorBytes first = to_bytes(vocabulary_.tree()[0].descriptor);
  EXPECT_EQ(bytes_.substr(80, 32), std::string(first.begin(), first.end()));
}

TEST_F(VocabularyFile, EveryTruncationIsFound) {
  for (std::size_t size = 0; size < bytes_.size(); size += size < 100 ? 1 : 37) {
    EXPECT_THAT(problem_of(bytes_.substr(0, size)), HasSubstr("cut off")) << size;
  }
  EXPECT_THAT(problem_of(bytes_ + "x"), HasSubstr("damaged"));
}

TEST_F(VocabularyFile, EveryDamagedByteIsFound) {
  for (std::size_t i = 0; i < bytes_.size(); i += i < 100 ? 1 : 13) {
    std::string damaged = bytes_;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x10);
    EXPECT_NE(problem_of(damaged), "none") << i;
  }
}

TEST_F(VocabularyFile, SaysWhatIsWrong) {
  std::string future = bytes_;
  future[8] = 2;
  EXPECT_THAT(problem_of(future), AllOf(HasSubstr("version 2"), HasSubstr("update")));
  std::string wide = bytes_;
  wide[21] = 2;
  EXPECT_THAT(problem_of(wide), HasSubstr("descriptors of 512 bits"));
  EXPECT_THAT(problem_of(std::string(100, 'x')), HasSubstr("no vocabulary"));
  EXPECT_THAT(problem_of("\x1f\x8b\b"), HasSubstr("no vocabulary: it begins neither"));
  EXPECT_THROW(static_cast<void>(read_vocabulary(folder_.path() / "none.voc")), InputError);
  EXPECT_THROW(static_cast<void>(read_vocabulary(folder_.path())), InputError);
  EXPECT_THROW(write_vocabulary(folder_.path() / "no" / "folder.voc", vocabulary_), OutputError);
}

// "is damaged" left open whether a binary file or ORB-SLAM's text was meant.
TEST_F(VocabularyFile, SaysAsWhatTheFileWasRead) {
  EXPECT_THAT(problem_of(bytes_ + "x"), HasSubstr("(read as a binary vocabulary)"));
  EXPECT_THAT(problem_of(bytes_.substr(0, 20)), HasSubstr("(read as a binary vocabulary)"));
  EXPECT_THAT(text_problem("10 6\n"), AllOf(HasSubstr("words.voc:1: the scoring"),
                                            HasSubstr("(read as ORB-SLAM's text vocabulary)")));
}

TEST_F(VocabularyFile, CountsOfTheHeaderAreComparedWithTheSizeOfTheFile) {
  std::string many = bytes_;
  for (std::size_t i = 24; i < 32; ++i) many[i] = '\xFF';  // nodes and words
  EXPECT_THAT(problem_of(many), HasSubstr("(4294967295 nodes, 4294967295 words): it is cut off"));
}

TEST_F(VocabularyFile, TextMayBeginWithAByteOrderMark) {
  write_vocabulary_text(folder_.path() / "words.txt", vocabulary_);
  const auto file =
      folder_.write("marked.txt", "\xEF\xBB\xBF" + read_text(folder_.path() / "words.txt"));
  EXPECT_EQ(vocabulary_bytes(read_vocabulary(file)), bytes_);
  EXPECT_THAT(problem_of(std::string("1\0000\0", 4)), HasSubstr("is UTF-16 text"));
}

}  // namespace
}  // namespace cvo_slam
