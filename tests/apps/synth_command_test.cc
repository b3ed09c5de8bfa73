// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/tests/apps/run_program.h"

namespace cvo_slam {
namespace {
namespace fs = std::filesystem;
using ::testing::HasSubstr;

/// Runs `synth room <folder>` for three small frames, with more arguments.
ProgramResult synth(const fs::path& folder, const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments = {"synth", "room",   folder, "--frames",
                                        "3",     "--size", "64x48"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run_program(arguments);
}

std::map<std::string, std::string> contents(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) {
      files[fs::relative(entry.path(), folder)] = read_text(entry.path());
    }
  }
  return files;
}

TEST(SynthCommand, NoiseChangesTheImagesAndTheSensorsSeedTheNoise) {
  const TemporaryFolder folder;
  EXPECT_EQ(synth(folder.path() / "none").exit_code, 0);
  EXPECT_EQ(synth(folder.path() / "kinect", {"--noise", "kinect"}).exit_code, 0);
  EXPECT_EQ(
      synth(folder.path() / "other", {"--noise", "kinect", "--set", "sensor.seed=2"}).exit_code, 0);
  const auto color = [&](const char* name) {
    return contents(folder.path() / name).at("rgb/1000.000000.png");
  };
  EXPECT_NE(color("none"), color("kinect"));
  EXPECT_NE(color("other"), color("kinect"));
}

TEST(SynthCommand, TheMarkerSaysHowToMakeTheSameBytesAgain) {
  const TemporaryFolder folder;
  const auto first = folder.path() / "first";
  const auto second = folder.path() / "second";
  ASSERT_EQ(synth(first, {"--noise", "harsh", "--set", "sensor.objects.count=1", "--seed", "3"})
                .exit_code,
            0);
  std::istringstream marker(read_text(first / "synthetic.yaml"));
  std::string line;
  while (std::getline(marker, line) && line.find("cvo_slam synth ") == std::string::npos) {
  }
  std::istringstream words(line.substr(line.find("synth ")));
  std::vector<std::string> arguments;
  for (std::string word; words >> word;) {
    arguments.push_back(word == "<folder>" ? second.string() : word);
  }
  ASSERT_EQ(run_program(arguments).exit_code, 0) << line;
  EXPECT_EQ(contents(first), contents(second));
}

TEST(SynthCommand, DumpedOptionsCanBeReadAgain) {
  const TemporaryFolder folder;
  const auto dumped = run_program({"synth", "--noise", "harsh", "--dump-config"});
  EXPECT_EQ(dumped.exit_code, 0);
  EXPECT_THAT(dumped.output,
              HasSubstr("    # Number of boxes that swing through the field of view."));
  const auto config = folder.write("sensor.yaml", dumped.output);
  const auto again = run_program({"synth", "--config", config, "--dump-config"});
  EXPECT_EQ(again.output, dumped.output);
  // A setting of the command line overrides the file.
  const auto set =
      run_program({"synth", "--config", config, "--set", "sensor.image.read=7", "--dump-config"});
  EXPECT_THAT(set.output, HasSubstr("read: 7\n"));
}

TEST(SynthCommand, BadArgumentsAreNamed) {
  const TemporaryFolder folder;
  const auto error = [&](const std::vector<std::string>& more) {
    const auto result = synth(folder.path() / "out", more);
    EXPECT_EQ(result.exit_code, 2);
    return result.errors;
  };
  EXPECT_THAT(error({"--noise", "kinetc"}), HasSubstr("did you mean 'kinect'?"));
  EXPECT_THAT(error({"--set", "sensor.depth.axal=1"}),
              HasSubstr("did you mean 'sensor.depth.axial'?"));
  EXPECT_THAT(error({"--set", "sensor.depth.axial=-1"}), HasSubstr("must be 0 to 100"));
  EXPECT_THAT(error({"--set", "sensor.seed"}), HasSubstr("must be key=value, e.g. sensor."));
  const auto config = folder.write("bad.yaml", "sensor:\n  depth:\n    axal: 1\n");
  EXPECT_THAT(error({"--config", config}), HasSubstr("bad.yaml:3: unknown option"));
  EXPECT_FALSE(fs::exists(folder.path() / "out"));
  const auto no_folder = run_program({"synth", "room"});
  EXPECT_EQ(no_folder.exit_code, 2);
  EXPECT_THAT(no_folder.errors, HasSubstr("say where to write the sequence"));
}

}  // namespace
}  // namespace cvo_slam
