// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/core/files.h"

#include <filesystem>
#include <iterator>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/tests/temporary_folder.h"

namespace cvo_slam {
namespace {

namespace fs = std::filesystem;

std::ptrdiff_t files_in(const fs::path& folder) {
  return std::distance(fs::directory_iterator(folder), {});
}

TEST(Files, WhatIsWrittenIsRead) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "a.bin";
  const std::string bytes("a\0b\r\n\xff", 6);
  write_file(file, bytes);
  EXPECT_EQ(read_file(file), bytes);
  write_file(file, "");
  EXPECT_EQ(read_file(file), "");
  EXPECT_EQ(files_in(folder.path()), 1) << "nothing is left aside";
}

TEST(Files, AnUnwrittenFileLeavesTheOldOne) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "a.txt";
  EXPECT_THROW(write_file(folder.path() / "missing" / "a.txt", "new"), OutputError);
  // A full disk: writing to it fails, which the name beside the file makes happen here.
  EXPECT_THROW(write_file("/dev/full", "new"), OutputError);
  write_file(file, "old");
  EXPECT_EQ(read_file(file), "old");
}

TEST(Files, LinksAndPermissionsStay) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "a.txt";
  write_file(file, "old");
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("a.txt", folder.path() / "link");
  write_file(folder.path() / "link", "new");
  EXPECT_TRUE(fs::is_symlink(folder.path() / "link"));
  EXPECT_EQ(read_file(file), "new");
  EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST(Files, AFolderIsNoFile) {
  const TemporaryFolder folder;
  EXPECT_THROW(static_cast<void>(read_file(folder.path())), InputError);
  EXPECT_THROW(static_cast<void>(read_file(folder.path() / "missing")), InputError);
  EXPECT_THROW(write_file(folder.path(), "bytes"), OutputError);
}

TEST(Files, FoldersAreMadeAndFilesRemoved) {
  const TemporaryFolder folder;
  EXPECT_TRUE(make_folder(folder.path() / "a" / "b"));
  EXPECT_FALSE(make_folder(folder.path() / "a" / "b"));
  write_file(folder.path() / "a" / "c", "");
  EXPECT_THROW(static_cast<void>(make_folder(folder.path() / "a" / "c" / "d")), OutputError);
  remove_file(folder.path() / "a" / "c");
  remove_file(folder.path() / "a" / "c");
  EXPECT_THROW(remove_file(folder.path() / "a"), OutputError) << "it is not empty";
}

}  // namespace
}  // namespace cvo_slam
