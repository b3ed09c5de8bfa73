// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/command_line.h"

#include <algorithm>

#include <CLI/CLI.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/tests/apps/run_program.h"

namespace cvo_slam {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

/// A program like ours, with a command that has options and one that has commands of its own.
class Usage : public testing::Test {
 protected:
  Usage() {
    app_.require_subcommand(1);
    CLI::App* run = app_.add_subcommand("run", "");
    run->add_option("dataset", dataset_, "")->required();
    run->add_option("--frames", frames_, "");
    run->add_option("--mode", mode_, "")->check(CLI::IsMember({"odometry", "slam"}));
    CLI::App* vocab = app_.add_subcommand("vocab", "");
    vocab->require_subcommand(1);
    vocab->add_subcommand("train", "");
  }

  std::string message_for(const std::string& command_line) {
    try {
      app_.parse(command_line);
    } catch (const CLI::ParseError& error) {
      return usage_message(app_, error);
    }
    return "accepted";
  }

 private:
  CLI::App app_{"", "cvo_slam"};
  std::string dataset_;
  std::string mode_;
  int frames_ = 0;
};

TEST_F(Usage, AMissingCommandListsThem) {
  EXPECT_EQ(message_for(""), "a command is required: run, vocab (see cvo_slam --help)");
  EXPECT_EQ(message_for("vocab"), "a command is required: train (see cvo_slam vocab --help)");
}

TEST_F(Usage, AnUnknownCommandNamesTheNearest) {
  EXPECT_EQ(message_for("rnu data"),
            "unknown command 'rnu'; did you mean 'run'? (see cvo_slam --help)");
  EXPECT_EQ(message_for("vocab trian"),
            "unknown command 'trian'; did you mean 'train'? (see cvo_slam vocab --help)");
}

TEST_F(Usage, AnUnknownWordThatIsNearNothingGetsTheList) {
  EXPECT_EQ(message_for("synthesize"),
            "unknown command 'synthesize'; there are: run, vocab (see cvo_slam --help)");
}

TEST_F(Usage, AnUnknownOptionNamesTheNearest) {
  const std::string expected =
      "unknown option '--framse'; did you mean '--frames'? (see cvo_slam run --help)";
  EXPECT_EQ(message_for("run data --framse 3"), expected);
  EXPECT_EQ(message_for("run data --framse=3"), expected);
}

TEST_F(Usage, ASurplusArgumentIsNamed) {
  EXPECT_EQ(message_for("run data more"), "unexpected argument 'more' (see cvo_slam run --help)");
}

TEST_F(Usage, MissingAndWrongValuesNameTheOption) {
  EXPECT_THAT(message_for("run"), StartsWith("dataset is required (see cvo_slam run"));
  EXPECT_THAT(message_for("run data --frames"), HasSubstr("--frames"));
  EXPECT_THAT(message_for("run data --frames x"), HasSubstr("--frames"));
  EXPECT_THAT(message_for("run data --mode fast"), HasSubstr("--mode: fast not in"));
  EXPECT_EQ(message_for("run data --mode slam"), "accepted");
}

TEST(Program, PrintsItsVersion) {
  const ProgramResult result = run_program({"--version"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.output, "cvo_slam " CVO_SLAM_VERSION "\n");
  EXPECT_THAT(result.errors, IsEmpty());
}

TEST(Program, PrintsItsHelpOnStdout) {
  const ProgramResult result = run_program({"--help"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.output, HasSubstr("Usage: cvo_slam"));
  EXPECT_THAT(result.errors, IsEmpty());
}

TEST(Program, WrongUsageIsOneLineOnStderrAndTwo) {
  const std::vector<std::vector<std::string>> command_lines = {
      {}, {"no-such-command"}, {"--no-such-option"}, {""}};
  for (const auto& arguments : command_lines) {
    const ProgramResult result = run_program(arguments);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.output, IsEmpty());
    EXPECT_THAT(result.errors, StartsWith("cvo_slam: error: "));
    EXPECT_THAT(result.errors, HasSubstr("(see cvo_slam --help)\n"));
    EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
  }
}

}  // namespace
}  // namespace cvo_slam
