// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cvo_slam/apps/command_line.h"
#include "cvo_slam/core/error.h"
#include "cvo_slam/io/camera_file.h"
#include "cvo_slam/tests/io/tiny_sequence.h"

namespace cvo_slam {
namespace {

using testing::HasSubstr;

Action parse(const std::string& arguments) {
  CLI::App app;
  Action action;
  add_info_command(app, action);
  app.parse("info " + arguments);
  return action;
}

/// Returns what `cvo_slam info <arguments>` prints.
std::string info(const std::string& arguments) {
  const Action action = parse(arguments);
  testing::internal::CaptureStdout();
  const int code = action();
  std::fflush(stdout);
  std::string output = testing::internal::GetCapturedStdout();
  EXPECT_EQ(code, kDone);
  return output;
}

class InfoCommand : public testing::Test {
 protected:
  void SetUp() override {
    sequence_.write_tum();
    sequence_.write("groundtruth.txt", "0.05 0 0 0 0 0 0 1\n0.20 3 4 0 0 0 0 1\n");
    write_camera(sequence_.path() / "camera.yaml", tiny_camera());
  }
  TinySequence sequence_;
};

TEST_F(InfoCommand, SaysWhatASequenceHolds) {
  const std::string text = info(sequence_.path().string());
  EXPECT_THAT(text, HasSubstr("kind       TUM RGB-D\n"));
  EXPECT_THAT(text, HasSubstr("camera     tiny: 8x6, fx 8 fy 8 cx 3.5 cy 2.5\n"));
  EXPECT_THAT(text, HasSubstr("origin     camera.yaml in the folder of the sequence\n"));
  EXPECT_THAT(text, HasSubstr("frames     2 in 0.10 s, 10.0 Hz\n"));
  EXPECT_THAT(text, HasSubstr("unpaired   0 colour, 0 depth images\n"));
  EXPECT_THAT(text, HasSubstr("reference  2 poses, 5.00 m, covers 1 of 2 frames\n"));
}

TEST_F(InfoCommand, SaysTheSameInJson) {
  const auto json = nlohmann::json::parse(info(sequence_.path().string() + " --json"));
  EXPECT_EQ(json["frames"], 2);
  EXPECT_EQ(json["camera"]["name"], "tiny");
  EXPECT_EQ(json["camera"]["depth"], nullptr);
  EXPECT_EQ(json["camera_origin"], "camera.yaml in the folder of the sequence");
  EXPECT_NEAR(json["rate_hz"], 10, 1e-9);
  EXPECT_EQ(json["reference"]["frames_covered"], 1);
  EXPECT_EQ(json["notes"].size(), 0);
}

TEST_F(InfoCommand, TakesABuiltInCameraByName) {
  EXPECT_THAT(info(sequence_.path().string() + " --camera icl_nuim"),
              HasSubstr("icl_nuim: 640x480"));
}

TEST_F(InfoCommand, FailsOnAMissingFolder) { EXPECT_THROW(parse("/nowhere")(), InputError); }

}  // namespace
}  // namespace cvo_slam
