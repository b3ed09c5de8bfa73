// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Runs on what others bring: their folders, their cameras.
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cvo_slam/io/camera_file.h"
#include "cvo_slam/tests/apps/room_sequence.h"
#include "cvo_slam/tests/apps/run_program.h"
#include "cvo_slam/tests/temporary_folder.h"

namespace cvo_slam {
namespace {

using testing::HasSubstr;

class ForeignRun : public testing::Test {
 protected:
  [[nodiscard]] ProgramResult run(const std::vector<std::string>& options,
                                  const std::string& out = "out") const {
    std::vector<std::string> arguments = {"run",    sequence_, "--out", folder_.path() / out,
                                          "--mode", "odometry"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_program(arguments);
  }

  [[nodiscard]] std::string file(const std::string& name, const std::string& out = "out") const {
    return read_text(folder_.path() / out / name);
  }

  RoomSequence room_{12};
  const TemporaryFolder& folder_ = room_.folder();
  const std::filesystem::path sequence_ = room_.path();
};

// It once removed config.yaml, map.ply and 14 other names from a folder that it had not made.
TEST_F(ForeignRun, AFolderOfTheUserIsLeftAlone) {
  const auto out = folder_.path() / "mine";
  std::filesystem::create_directory(out);
  folder_.write("mine/config.yaml", "tracker.points: 1500\n");
  const std::vector<std::string> arguments = {"--quiet", "--config", out / "config.yaml"};
  expect_error(run(arguments, "mine"), 1, "give --overwrite");
  EXPECT_EQ(file("config.yaml", "mine"), "tracker.points: 1500\n");
  ASSERT_EQ(run({"--quiet", "--overwrite"}, "mine").exit_code, 0);
  EXPECT_EQ(run({"--quiet"}, "mine").exit_code, 0) << "now it is the folder of a run";
}

TEST_F(ForeignRun, ARunWhoseImagesAreOfTheWrongKindStopsAtOnce) {
  Camera camera = read_camera(sequence_ / "camera.yaml");
  camera.color.width *= 2;
  const auto file_of_camera = folder_.path() / "wrong.yaml";
  write_camera(file_of_camera, camera);
  const auto result = run({"--quiet", "--camera", file_of_camera});
  expect_error(result, 2, "none of the first 10 frames can be used");
  EXPECT_THAT(result.errors, HasSubstr("the image has 160x120 pixels, its camera 320x120"));
  const auto report = nlohmann::json::parse(file("report.json"));
  EXPECT_EQ(report["frames"]["processed"], 10);
  EXPECT_THAT(report["first_lost"]["reason"].get<std::string>(), HasSubstr("160x120 pixels"));
  EXPECT_THAT(file("report.html"), HasSubstr("the image has 160x120 pixels, its camera 320x120"));
}

TEST_F(ForeignRun, NamesTheCameraAndWarnsOfAWrongDepthScale) {
  Camera camera = read_camera(sequence_ / "camera.yaml");
  camera.depth_scale /= 2;
  const auto file_of_camera = folder_.path() / "scaled.yaml";
  write_camera(file_of_camera, camera);
  const auto result = run({"--camera", file_of_camera});
  EXPECT_THAT(result.output, HasSubstr("camera       synthetic: given by the caller\n"));
  EXPECT_THAT(result.output, HasSubstr("times as large as the estimate; is the depth_scale"));
  EXPECT_EQ(nlohmann::json::parse(file("report.json"))["camera_origin"], "given by the caller");
  EXPECT_THAT(file("report.html"), HasSubstr("(given by the caller)"));
}

TEST_F(ForeignRun, StepsOfFramesCannotOverflow) {
  const auto result = run({"--quiet", "--frames", "0:12:18446744073709551615"});
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(nlohmann::json::parse(file("report.json"))["frames"]["processed"], 1);
}

}  // namespace
}  // namespace cvo_slam
