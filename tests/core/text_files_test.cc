// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/tests/temporary_folder.h"

namespace cvo_slam {
namespace {

using namespace std::string_literals;

// Windows' Notepad writes a byte order mark; the first stamp of a list was then no number.
TEST(TextFiles, AByteOrderMarkIsSkipped) {
  const TemporaryFolder folder;
  EXPECT_EQ(read_text_file(folder.write("a.txt",
                                        "\xEF\xBB\xBF"
                                        "1 a\n")),
            "1 a\n");
  EXPECT_EQ(read_text_file(folder.write("b.txt", "\xEF\xBB\xBF")), "");
  EXPECT_EQ(read_text_file(folder.write("c.txt", "1 a\n")), "1 a\n");
  EXPECT_EQ(read_text_file(folder.write("d.txt", "")), "");
}

// PowerShell's ">" writes UTF-16.
TEST(TextFiles, Utf16IsNamed) {
  const TemporaryFolder folder;
  for (const std::string& bytes : {"\xFF\xFE"
                                   "1\0 \0"s,
                                   "\xFE\xFF\0"
                                   "1\0 "s,
                                   "1\0 \0"s,
                                   "\0"
                                   "1\0 "s}) {
    const auto file = folder.write("a.txt", bytes);
    try {
      static_cast<void>(read_text_file(file));
      FAIL() << "no error";
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr("a.txt: is UTF-16 text; save it as UTF-8"));
    }
  }
}

}  // namespace
}  // namespace cvo_slam
