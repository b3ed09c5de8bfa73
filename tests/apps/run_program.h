// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "cvo_slam/tests/temporary_folder.h"

namespace cvo_slam {

struct ProgramResult {
  int exit_code = -1;  ///< of a program ended by a signal: 128 + its number, as in a shell
  std::string output;  ///< what it wrote to stdout
  std::string errors;  ///< what it wrote to stderr
};

/// Files for the output of the program; empty = a temporary file whose text the result has.
struct ProgramStreams {
  std::string output = {};
  std::string errors = {};
  std::string input = "/dev/null";
};

/// Runs the built program with these arguments and waits for its end; stdin is empty unless given.
inline ProgramResult run_program(const std::vector<std::string>& arguments,
                                 const ProgramStreams& streams = {}) {
  const TemporaryFolder folder;
  const std::string output =
      streams.output.empty() ? folder.path() / "stdout" : std::filesystem::path(streams.output);
  const std::string errors =
      streams.errors.empty() ? folder.path() / "stderr" : std::filesystem::path(streams.errors);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  constexpr int kWrite = O_WRONLY | O_CREAT | O_TRUNC;
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, streams.input.c_str(), O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, output.c_str(), kWrite, 0600);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, errors.c_str(), kWrite, 0600);

  std::vector<std::string> words = {CVO_SLAM_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (auto& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  pid_t process = 0;
  const int problem =
      posix_spawn(&process, CVO_SLAM_PROGRAM, &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (problem != 0) return {};

  int status = 0;
  waitpid(process, &status, 0);
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return {code, streams.output.empty() ? read_text(output) : "",
          streams.errors.empty() ? read_text(errors) : ""};
}

/// Expects that the program failed with this exit code and one line on stderr that has `text`.
inline void expect_error(const ProgramResult& result, int code, const std::string& text) {
  EXPECT_EQ(result.exit_code, code) << result.errors;
  EXPECT_THAT(result.errors, testing::MatchesRegex("cvo_slam: error: [^\n]+\n"));
  EXPECT_THAT(result.errors, testing::HasSubstr(text));
}

}  // namespace cvo_slam
