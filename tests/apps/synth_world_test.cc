// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The choice of the world and the path in `cvo_slam synth`.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/tests/apps/run_program.h"

namespace cvo_slam {
namespace {

using testing::HasSubstr;

class SynthWorld : public testing::Test {
 protected:
  /// Writes two small frames into a folder of that name.
  [[nodiscard]] ProgramResult synth(const std::string& world, const std::string& name,
                                    const std::vector<std::string>& options = {}) const {
    std::vector<std::string> words = {"synth", world,    path(name), "--frames",
                                      "2",     "--size", "32x24"};
    words.insert(words.end(), options.begin(), options.end());
    return run_program(words);
  }
  [[nodiscard]] std::string path(const std::string& name) const { return folder_.path() / name; }
  [[nodiscard]] std::string second_frame(const std::string& name) const {
    return read_text(folder_.path() / name / "rgb" / "1000.033333.png");
  }

  TemporaryFolder folder_;
};

TEST_F(SynthWorld, ADumpedWorldGivesTheSameImages) {
  const auto dumped = run_program({"synth", "office", "--dump-world", path("office.yaml")});
  EXPECT_EQ(dumped.exit_code, 0) << dumped.errors;
  EXPECT_THAT(dumped.output, HasSubstr("path of 24.0 s"));
  EXPECT_EQ(synth("office", "built_in").exit_code, 0);
  EXPECT_EQ(synth(path("office.yaml"), "from_file").exit_code, 0);
  EXPECT_FALSE(second_frame("built_in").empty());
  EXPECT_EQ(second_frame("built_in"), second_frame("from_file"));
}

TEST_F(SynthWorld, PathAndSpeedAreTakenAndNoted) {
  EXPECT_EQ(synth("room", "still", {"--path", "still", "--speed", "2"}).exit_code, 0);
  const std::string marker = read_text(folder_.path() / "still" / "synthetic.yaml");
  EXPECT_THAT(marker, HasSubstr("path: still\nspeed: 2\n"));
  EXPECT_EQ(second_frame("still"), read_text(folder_.path() / "still" / "rgb" / "1000.000000.png"));
}

TEST_F(SynthWorld, WhatIsWrongIsSaidInOneLine) {
  EXPECT_THAT(synth("offise", "x").errors, HasSubstr("did you mean 'office'?"));
  EXPECT_EQ(synth("offise", "x").exit_code, 2);
  EXPECT_THAT(synth(path("none.yaml"), "x").errors, HasSubstr("none.yaml: cannot be opened"));
  EXPECT_THAT(synth("structure_texture_near", "x", {"--path", "walk"}).errors,
              HasSubstr("use handheld"));
  EXPECT_THAT(run_program({"synth", "room"}).errors, HasSubstr("say where to write"));
  EXPECT_THAT(run_program({"synth", "room", "--dump-world", "/proc/w.yaml"}).errors,
              HasSubstr("/proc/w.yaml"));
}

}  // namespace
}  // namespace cvo_slam
