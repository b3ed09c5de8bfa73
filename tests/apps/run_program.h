// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

namespace cvo_slam {

/// What a run of the program left.
struct ProgramResult {
  int exit_code;
  std::string out;
  std::string err;
};

namespace run_program_detail {

inline std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

inline std::string take_file(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  std::filesystem::remove(file);
  return text;
}

}  // namespace run_program_detail

/// Runs the program cvo_slam as a process of its own. CVO_SLAM_PROGRAM is its path.
inline ProgramResult run_program(const std::vector<std::string>& arguments) {
  using run_program_detail::quoted;
  // Tests run in parallel, a process each.
  const auto base = std::filesystem::temp_directory_path() /
                    ("cvo_slam_run_program_" + std::to_string(::getpid()));
  const std::string out = base.string() + ".out";
  const std::string err = base.string() + ".err";
  std::string command = quoted(CVO_SLAM_PROGRAM);
  for (const std::string& argument : arguments) command += " " + quoted(argument);
  const int status = std::system((command + " >" + quoted(out) + " 2>" + quoted(err)).c_str());
  const int exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return {exit_code, run_program_detail::take_file(out), run_program_detail::take_file(err)};
}

}  // namespace cvo_slam
