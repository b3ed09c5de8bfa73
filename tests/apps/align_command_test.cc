// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// `cvo_slam align` from outside: what it prints and draws, its exit codes, its errors.
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "cvo_slam/io/dataset.h"
#include "cvo_slam/tests/apps/room_sequence.h"
#include "cvo_slam/tests/apps/run_program.h"

namespace cvo_slam {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::MatchesRegex;

class AlignCommand : public testing::Test {
 protected:
  [[nodiscard]] ProgramResult align(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"align", room_.string()});
    return run_program(arguments);
  }

  /// The images of frame `index`, colour and depth.
  [[nodiscard]] std::vector<std::string> images(std::size_t index) const {
    return {sequence_.images("rgb").at(index), sequence_.images("depth").at(index)};
  }

  [[nodiscard]] static ProgramResult align_images(const std::vector<std::string>& a,
                                                  const std::vector<std::string>& b,
                                                  const std::string& camera) {
    return run_program({"align", a[0], a[1], b[0], b[1], "--camera", camera, "--json"});
  }

  static void expect_error(const ProgramResult& result, int code, const std::string& text) {
    EXPECT_EQ(result.exit_code, code) << result.errors;
    EXPECT_THAT(result.errors, MatchesRegex("cvo_slam: error: [^\n]+\n"));
    EXPECT_THAT(result.errors, HasSubstr(text));
    EXPECT_EQ(result.output, "");
  }

  RoomSequence sequence_{6};
  const TemporaryFolder& folder_ = sequence_.folder();
  const std::filesystem::path room_ = sequence_.path();
};

TEST_F(AlignCommand, FindsTheMotionBetweenTwoFrames) {
  const ProgramResult result = align({"1", "3", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const auto json = nlohmann::json::parse(result.output);
  const auto found = json["T_a_b"]["translation_m"].get<std::vector<double>>();
  // One of the 160 pixels is 4 mm wide at a metre. If the motion is not found, all of it is error.
  EXPECT_LT(json["error"]["translation_m"], 0.3 * std::hypot(found[0], found[1], found[2]));
  EXPECT_GT(json["after"]["cos_theta"], json["before"]["cos_theta"]);
  EXPECT_GT(json["after"]["inner_product"], json["before"]["inner_product"]);
  EXPECT_GT(json["iterations"], 0);
  EXPECT_EQ(json["status"], "converged");
  EXPECT_EQ(json["information"].size(), 6U);
  EXPECT_NEAR(json["interval_s"], 2 / 30.0, 1e-3);
  for (const double deviation : json["standard_deviation"]["translation_m"]) {
    EXPECT_GT(deviation, 0);
    EXPECT_LT(deviation, 0.1);
  }
}

TEST_F(AlignCommand, TheOtherWayRoundIsTheInverse) {
  const auto there = nlohmann::json::parse(align({"1", "3", "--json"}).output);
  const auto back = nlohmann::json::parse(align({"3", "1", "--json"}).output);
  const auto a = there["T_a_b"]["translation_m"].get<std::vector<double>>();
  const auto b = back["T_a_b"]["translation_m"].get<std::vector<double>>();
  EXPECT_LT(a[0] * b[0] + a[1] * b[1] + a[2] * b[2], 0);
  EXPECT_NEAR(back["interval_s"], -2 / 30.0, 1e-3);
}

TEST_F(AlignCommand, PrintsATable) {
  const ProgramResult result = align({"0", "1"});
  EXPECT_EQ(result.exit_code, 0);
  for (const char* text :
       {"a              frame 0 of room (TUM RGB-D)", "b              frame 1, +0.033 s", "T_a_b",
        "motion", "deviations     x y z", "from the reference", "cos_theta", "inner product",
        "overlap", "kernel matrix", "iterations", "CPU time"}) {
    EXPECT_THAT(result.output, HasSubstr(text));
  }
}

TEST_F(AlignCommand, TakesStampsAndOptions) {
  const std::string stamp = open_dataset(room_)->stamp(3).to_string();
  const auto by_stamp = nlohmann::json::parse(align({"1", stamp, "--json"}).output);
  EXPECT_EQ(by_stamp["b"], "frame 3");
  const auto paper = nlohmann::json::parse(align({"1", "3", "--preset", "paper", "--json"}).output);
  EXPECT_EQ(paper["length_scale_m"], 0.03);  // the last of the paper's table
}

TEST_F(AlignCommand, TakesImageFiles) {
  const std::string camera = room_ / "camera.yaml";
  const ProgramResult result = align_images(images(1), images(3), camera);
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const auto json = nlohmann::json::parse(result.output);
  const auto of_sequence = nlohmann::json::parse(align({"1", "3", "--json"}).output);
  EXPECT_EQ(json["T_a_b"], of_sequence["T_a_b"]);
  EXPECT_EQ(json["error"], nullptr);
  EXPECT_FALSE(json.contains("interval_s"));
}

TEST_F(AlignCommand, DrawsTheRegistrationAndTheStep) {
  const auto plots = folder_.path() / "new" / "plots";
  const ProgramResult result = align({"0", "5", "--preset", "paper", "--plot", plots.string()});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  for (const char* name : {"registration", "step"}) {
    const cv::Mat image = cv::imread((plots / name).string() + ".png");
    ASSERT_FALSE(image.empty());
    cv::Scalar mean;
    cv::Scalar deviation;
    cv::meanStdDev(image, mean, deviation);
    EXPECT_GT(deviation[0], 10) << name;
  }
  const std::string registration = read_text(plots / "registration.svg");
  EXPECT_THAT(registration, AllOf(HasSubstr(">before<"), HasSubstr(">a: frame 0<"),
                                  HasSubstr(" entries, cos_theta "), HasSubstr("points of b<")));
  const std::string step = read_text(plots / "step.svg");
  EXPECT_THAT(step, AllOf(HasSubstr("length scale 0.15 m"), HasSubstr(">exact<"),
                          HasSubstr(">2nd order<"), HasSubstr(">4th order<")));
}

TEST_F(AlignCommand, AResultThatATrackerWouldRejectHasItsExitCode) {
  const ProgramResult result = align({"0", "5", "--set", "tracker.lost.min_overlap=1"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.output, HasSubstr("rejected       overlap 0."));
}

TEST_F(AlignCommand, UnknownFramesAreAClearLine) {
  expect_error(align({"0", "6"}), 2, "there is no frame 6; the sequence has frames 0 to 5");
  expect_error(align({"0", "one"}), 2,
               "frame 'one' is neither a number nor a stamp; write e.g. 12");
  expect_error(align({"0", "99.5"}), 2, "frame 99.5: no frame has a stamp within 0.02 s");
  expect_error(align({"2", "2"}), 2, "2 and 2 are both frame 2; name two frames");
  expect_error(align({"0"}), 2, "3 or 4 arguments are needed, not 2: a sequence and");
  expect_error(run_program({"align", "/nowhere", "0", "1"}), 2, "/nowhere");
}

TEST_F(AlignCommand, FramesThatCannotBeUsedAreAClearLine) {
  cv::imwrite(images(2)[1], cv::Mat(120, 160, CV_16UC1, cv::Scalar(0)));
  expect_error(align({"0", "2"}), 2, "the depth image has no valid pixel");
  cv::imwrite(images(3)[0], cv::Mat(10, 10, CV_8UC3, cv::Scalar(0)));
  expect_error(align({"3", "0"}), 2, "the image has 10x10 pixels, its camera 160x120");
  cv::imwrite(images(4)[0], cv::Mat(120, 160, CV_8UC3, cv::Scalar(90, 90, 90)));
  expect_error(align({"0", "4"}), 1, "frame 4 has 0 points with gradient and depth");
  std::filesystem::remove(images(5)[0]);
  expect_error(align({"0", "5"}), 2, "frame 5 of room cannot be used");
}

TEST_F(AlignCommand, ImageFilesThatCannotBeUsedAreAClearLine) {
  const std::string camera = room_ / "camera.yaml";
  const auto a = images(0);
  const auto b = images(1);
  expect_error(run_program({"align", a[0], a[1], b[0], b[1]}), 2, "name it with --camera");
  expect_error(align_images(a, a, camera), 2, "is the colour image of both frames");
  expect_error(align_images(a, {b[0], "/none.png"}, camera), 2, "/none.png");
  // Depth and colour are exchanged.
  expect_error(align_images({a[1], a[0]}, b, camera), 2, "a colour image must have 8 bits");
  expect_error(align_images(a, b, "no_camera"), 2, "no_camera");
}

TEST_F(AlignCommand, AnUnwritableFolderIsKnownBeforeTheWork) {
  const std::string file = folder_.write("file", "");
  expect_error(align({"0", "1", "--plot", file + "/plots"}), 1, file);
}

TEST_F(AlignCommand, ViewsThatShareNothingAreAnError) {
  // The depth of the second frame is twice that of the room: the frames show different surfaces.
  cv::Mat far = cv::imread(images(1)[1], cv::IMREAD_UNCHANGED);
  far = 2 * far;
  cv::imwrite(images(1)[1], far);
  const ProgramResult result = align({"0", "1", "--set", "tracker.selection.max_depth=12"});
  EXPECT_TRUE(result.exit_code == 1 || result.exit_code == 3) << result.output;
}

}  // namespace
}  // namespace cvo_slam
