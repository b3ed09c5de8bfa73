// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <chrono>
#include <fstream>
#include <future>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cvo_slam/tests/apps/room_sequence.h"
#include "cvo_slam/tests/apps/run_program.h"

namespace cvo_slam {
namespace {

using testing::HasSubstr;

std::vector<std::string> lines_of(const std::filesystem::path& file) {
  std::istringstream text(read_text(file));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line + "\n");
  return lines;
}

class FollowRun : public testing::Test {
 protected:
  [[nodiscard]] ProgramResult run(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"run", sequence_.path(), "--out", out(), "--overwrite"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(arguments);
  }
  [[nodiscard]] std::filesystem::path out() const { return sequence_.folder().path() / "out"; }

  /// The lists are written again while the program runs, a line every 20 ms.
  static void record(const std::filesystem::path& folder, const std::vector<std::string>& colors,
                     const std::vector<std::string>& depths) {
    for (std::size_t i = 0; i < std::max(colors.size(), depths.size()); ++i) {
      if (i < colors.size()) std::ofstream(folder / "rgb.txt", std::ios::app) << colors[i];
      if (i < depths.size()) std::ofstream(folder / "depth.txt", std::ios::app) << depths[i];
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  }

  RoomSequence sequence_{12};
};

TEST_F(FollowRun, GivesTheBytesOfARunOfTheWholeRecording) {
  ASSERT_EQ(run().exit_code, 0);
  const std::string trajectory = read_text(out() / "trajectory.txt");
  const auto colors = lines_of(sequence_.path() / "rgb.txt");
  const auto depths = lines_of(sequence_.path() / "depth.txt");
  std::filesystem::remove(sequence_.path() / "rgb.txt");
  std::filesystem::remove(sequence_.path() / "depth.txt");
  const auto recorder =
      std::async(std::launch::async, [&] { record(sequence_.path(), colors, depths); });
  const auto result = run({"--follow", "--end-after", "1"});
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(result.errors, HasSubstr("waiting for frames in "));
  EXPECT_EQ(read_text(out() / "trajectory.txt"), trajectory);
  const auto report = nlohmann::json::parse(read_text(out() / "report.json"));
  EXPECT_EQ(report["frames"]["processed"], 12);
  EXPECT_EQ(report["frames"]["end"], 12);
  EXPECT_TRUE(report.contains("evaluation"));
}

TEST_F(FollowRun, ARecordingThatNeverBeginsIsOneLine) {
  const auto empty = sequence_.folder().path() / "empty";
  std::filesystem::create_directory(empty);
  const auto result = run_program({"run", empty, "--follow", "--end-after", "0.1", "--quiet"});
  expect_error(result, 2, "is no known data set");
}

TEST_F(FollowRun, WhatNeedsTheWholeRecordingIsRefused) {
  expect_error(run({"--follow", "--quiet", "--frames", "0:5"}), 2,
               "which --follow and a pipe do not know");
  expect_error(run({"--follow", "--quiet", "--depth-offset", "measure"}), 2,
               "needs a whole recording");
}

// A recorder names the images on a pipe.
TEST_F(FollowRun, PairsFromStandardInputGiveTheSameBytes) {
  ASSERT_EQ(run().exit_code, 0);
  const std::string trajectory = read_text(out() / "trajectory.txt");
  std::string pairs;
  const auto colors = lines_of(sequence_.path() / "rgb.txt");
  const auto depths = lines_of(sequence_.path() / "depth.txt");
  ASSERT_EQ(colors.size(), depths.size());
  for (std::size_t i = 0; i < colors.size(); ++i) {
    for (const std::string& line : {colors[i], depths[i]}) {
      if (line.starts_with('#')) continue;
      const std::size_t blank = line.find(' ');
      pairs += line.substr(0, blank + 1) + (sequence_.path() / line.substr(blank + 1)).string();
      pairs.back() = ' ';  // in place of the end of the line
    }
    pairs += '\n';
  }
  const auto input = sequence_.folder().write("pairs.txt", pairs);
  const auto camera = (sequence_.path() / "camera.yaml").string();
  const auto result = run_program({"run", "-", "--camera", camera, "--out", out(), "--overwrite"},
                                  {.input = input.string()});
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(result.errors, HasSubstr("waiting for frames on standard input"));
  EXPECT_EQ(read_text(out() / "trajectory.txt"), trajectory);
  expect_error(run_program({"run", "-", "--quiet"}), 2, "--camera");
  expect_error(
      run_program({"run", "-", "--quiet", "--camera", camera, "--out", out(), "--overwrite"}), 2,
      "ended before a frame came");
}

TEST_F(FollowRun, AnInterruptEndsIt) {
  const auto file = sequence_.folder().path();
  const std::string script = fmt::format(
      "'{0}' run '{1}' --follow --end-after 60 --quiet --out '{2}' & "
      "for i in $(seq 1000); do [ -e '{2}/trajectory.txt' ] && break; sleep 0.01; done; "
      "sleep 0.3; kill -INT $!; wait $!",
      CVO_SLAM_PROGRAM, sequence_.path().string(), out().string());
  const int status = std::system(script.c_str());
  EXPECT_EQ(WEXITSTATUS(status), 130);
  EXPECT_TRUE(std::filesystem::exists(out() / "report.json"));
  // It listens before it says that it waits.
  const std::string waiting = fmt::format(
      "'{0}' run '{1}/none' --follow --end-after 60 2> '{1}/said' & for i in $(seq 1000); do "
      "grep -q waiting '{1}/said' && break; sleep 0.01; done; kill -INT $!; wait $!",
      CVO_SLAM_PROGRAM, file.string());
  EXPECT_EQ(WEXITSTATUS(std::system(waiting.c_str())), 130);
}

}  // namespace
}  // namespace cvo_slam
