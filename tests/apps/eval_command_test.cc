// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cvo_slam/core/trajectory_errors.h"
#include "cvo_slam/io/trajectory_files.h"
#include "cvo_slam/tests/apps/run_program.h"
#include "cvo_slam/tests/core/trajectory_samples.h"
#include "cvo_slam/tests/temporary_folder.h"
#include "cvo_slam/tests/test_data.h"

namespace cvo_slam {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;

class EvalCommand : public testing::Test {
 protected:
  EvalCommand() {
    write_tum(reference_, {helix(40), {}});
    write_tum(estimate_, {transformed({SE3(so3_exp({0, 0, 1}), {1, 2, 3}), 1}, helix(40)), {}});
  }

  [[nodiscard]] ProgramResult eval(const std::vector<std::string>& options) const {
    std::vector<std::string> arguments = {"eval", reference_, estimate_};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_program(arguments);
  }

  /// Checks the exit code and that there is one line of error which holds `text`.
  static void expect_error(const ProgramResult& result, int code, const std::string& text) {
    EXPECT_EQ(result.exit_code, code);
    EXPECT_THAT(result.errors, MatchesRegex("cvo_slam: error: [^\n]+\n"));
    EXPECT_THAT(result.errors, HasSubstr(text));
    EXPECT_EQ(result.output, "");
  }

  TemporaryFolder folder_;
  std::filesystem::path reference_ = folder_.path() / "reference.txt";
  std::filesystem::path estimate_ = folder_.path() / "estimate.txt";
};

TEST_F(EvalCommand, AFullStdoutIsAnError) {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"eval", reference_, estimate_, "--json"}, {"--version"}}) {
    expect_error(run_program(arguments, {.output = "/dev/full"}), 1, "");
  }
}

TEST_F(EvalCommand, PrintsATable) {
  const auto result = eval({});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.errors, "");
  for (const char* text : {"matched    40 of 40 poses (100.0 %)", "alignment  se3", "ATE",
                           "RPE 1 s", "RPE 1 frame", "translation [m]", "rotation [deg]"}) {
    EXPECT_THAT(result.output, HasSubstr(text));
  }
}

TEST_F(EvalCommand, ComparesTheClocks) {
  write_tum(reference_, {swaying(12), {}});
  write_tum(estimate_, {by_late_clock(swaying(12), 30), {}});
  const auto table = eval({"--time-offset", "auto", "--max-diff", "0.05"}).output;
  EXPECT_THAT(table, HasSubstr("the offset between the clocks at which the rotations agree best"));
  EXPECT_THAT(table, HasSubstr("stamps of the estimate shifted by -0.0"));
  const auto json = nlohmann::json::parse(eval({"--time-offset", "auto", "--json"}).output);
  EXPECT_EQ(json["time_offset_s"], 0.0) << "the figures without it stay";
  const auto& best = json["at_best_time_offset"];
  EXPECT_NEAR(best["time_offset_s"].get<double>(), -0.03, 1e-3);
  EXPECT_LT(best["ate"]["translation_m"]["rmse"],
            0.1 * json["ate"]["translation_m"]["rmse"].get<double>());
  EXPECT_EQ(eval({"--time-offset", "+0.01"}).exit_code, 0);
  expect_error(eval({"--time-offset", "soon"}), 2,
               "--time-offset 'soon': expected seconds or auto");
}

TEST_F(EvalCommand, WhereTheCameraDoesNotTurnTheClocksAreNotCompared) {
  write_tum(reference_, {line(60), {}});
  write_tum(estimate_, {line(60), {}});
  const auto table = eval({"--time-offset", "auto", "--align", "none"}).output;
  EXPECT_THAT(table, HasSubstr("the clocks of the two were not compared"));
}

TEST_F(EvalCommand, PrintsOneJsonObject) {
  const auto result = eval({"--json", "--align", "none"});
  EXPECT_EQ(result.exit_code, 0);
  const auto json = nlohmann::json::parse(result.output);
  EXPECT_EQ(json["matches"], 40);
  // The estimate is turned by one radian.
  EXPECT_NEAR(json["ate"]["rotation_deg"]["rmse"].get<double>(), 57.29578, 1e-5);
}

TEST_F(EvalCommand, MetricsHaveTheirOwnDefaults) {
  const auto rpe = [&](const std::vector<std::string>& options) {
    auto all = options;
    all.emplace_back("--json");
    return nlohmann::json::parse(eval(all).output)["rpe"];
  };
  // 40 poses, 100 ms apart.
  EXPECT_EQ(rpe({"--metric", "tum"})[0]["error"]["count"], 30);
  EXPECT_EQ(rpe({"--metric", "tum", "--delta", "2"})[0]["error"]["count"], 20);
  EXPECT_EQ(rpe({"--metric", "evo"})[0]["error"]["count"], 39);
  EXPECT_EQ(rpe({"--delta", "10"})[0]["error"]["count"], 3);
  EXPECT_EQ(rpe({"--delta", "10", "--all-pairs"})[0]["error"]["count"], 30);
  EXPECT_EQ(rpe({"--delta", "1", "--unit", "s"})[0]["error"]["count"], 3);
  EXPECT_EQ(rpe({"--metric", "paper"})[0]["definition"], "cvo_paper");
  EXPECT_EQ(rpe({"--metric", "paper"}).size(), 1U);
}

TEST_F(EvalCommand, TimeOffsetMayBeNegative) {
  const auto json = nlohmann::json::parse(eval({"--time-offset", "-1", "--json"}).output);
  // The first ten poses fall before the reference.
  EXPECT_EQ(json["matches"], 30);
  EXPECT_EQ(json["time_offset_s"], -1.0);
}

TEST_F(EvalCommand, WritesPictures) {
  const auto plots = folder_.path() / "new" / "plots";
  EXPECT_EQ(eval({"--plot", plots}).exit_code, 0);
  for (const char* name : {"trajectory.png", "trajectory.svg", "errors.png", "errors.svg"}) {
    EXPECT_GT(std::filesystem::file_size(plots / name), 1000U) << name;
  }
}

TEST_F(EvalCommand, PicturesThatCannotBeWrittenAreAFailure) {
  const auto file = folder_.write("file", "");
  expect_error(eval({"--plot", file}), 1, "file: ");
  expect_error(eval({"--plot", file / "below"}), 1, "below: ");
}

TEST_F(EvalCommand, WrongUsage) {
  expect_error(run_program({"eval"}), 2, "reference is required");
  expect_error(eval({"--no-such-option"}), 2, "--no-such-option");
  expect_error(eval({"--align", "affine"}), 2, "affine");
  expect_error(eval({"--delta", "x"}), 2, "--delta");
  expect_error(eval({"--delta", "0"}), 2, "delta 0");
  expect_error(eval({"--delta", "nan"}), 2, "delta nan");
  expect_error(eval({"--max-diff", "-1"}), 2, "max difference");
  expect_error(eval({"--metric", "paper", "--delta", "2"}), 2, "frame to frame");
  expect_error(eval({"--metric", "tum", "--unit", "m"}), 2, "over seconds");
}

TEST_F(EvalCommand, BadInput) {
  const auto missing = folder_.path() / "missing.txt";
  expect_error(run_program({"eval", missing, estimate_}), 2, "missing.txt: cannot be opened");
  const auto empty = folder_.write("empty.txt", "# nothing\n");
  expect_error(run_program({"eval", reference_, empty}), 2, "has no pose");
  expect_error(run_program({"eval", empty, estimate_}), 2, "empty.txt: has no pose");
  const auto nan = folder_.write("nan.txt", "1 nan 0 0 0 0 0 1\n");
  expect_error(run_program({"eval", reference_, nan}), 2, "nan.txt: has no pose with finite numb");
  const auto comma = folder_.write("comma.txt", "1 0 0 0 0 0 0 1\n2 0,5 0 0 0 0 0 1\n");
  expect_error(run_program({"eval", reference_, comma}), 2, "comma.txt:2: '0,5' has a decimal");
  const auto wide = folder_.write("wide.txt", std::string("1\0 \0", 4));
  expect_error(run_program({"eval", reference_, wide}), 2, "wide.txt: is UTF-16 text");
  const auto later = folder_.write("later.txt", "1000 0 0 0 0 0 0 1\n");
  expect_error(run_program({"eval", reference_, later}), 2, "later.txt: no pose of the estimate");
  const auto single = folder_.write("single.txt", "1 0 0 0 0 0 0 1\n");
  expect_error(run_program({"eval", reference_, single}), 2, "alignment needs at least 3");
  expect_error(run_program({"eval", folder_.path(), estimate_}), 2, "is a folder");
}

// For a file whose stamps were rounded to seconds the program said "27 of 27 poses (100 %)": the
// other lines had vanished.
TEST_F(EvalCommand, LinesThatAreLeftOutAreCountedAndSaid) {
  std::string rounded;
  for (const auto& pose : helix(40)) {
    const Vector3& t = pose.T_world_camera.translation();
    rounded += fmt::format("{:.0f} {} {} {} 0 0 0 1\n", std::floor(pose.stamp.seconds()), t.x(),
                           t.y(), t.z());
  }
  const auto file = folder_.write("rounded.txt", rounded);
  const auto table = run_program({"eval", reference_, file}).output;
  // The 40 poses are 100 ms apart: four seconds.
  EXPECT_THAT(table, HasSubstr("matched    4 of 40 poses (10.0 %) with 40 of the reference"));
  EXPECT_THAT(table, HasSubstr("left out   36 poses of the estimate: the stamp is that of an"));
  EXPECT_THAT(table,
              HasSubstr("warning: 36 of the 40 poses of the estimate are left out; 36 have"));
  const auto json = nlohmann::json::parse(run_program({"eval", reference_, file, "--json"}).output);
  EXPECT_EQ(json["matches"], 4);
  EXPECT_EQ(json["estimate_poses"], 40);
  EXPECT_EQ(json["coverage"], 0.1);
  EXPECT_EQ(json["left_out"]["estimate"]["repeated_stamp"], 36);
  EXPECT_EQ(json["left_out"]["reference"]["repeated_stamp"], 0);
  EXPECT_EQ(json["warnings"].size(), 1U);
}

TEST_F(EvalCommand, PosesThatAreNotFiniteAreCountedAndSaid) {
  const auto file = folder_.write("nan.txt", read_text(estimate_) + "90 nan nan nan 0 0 0 1\n");
  const auto table = run_program({"eval", reference_, file}).output;
  EXPECT_THAT(table, HasSubstr("matched    40 of 41 poses (97.6 %)"));
  EXPECT_THAT(table, HasSubstr("left out   1 poses of the estimate: not finite"));
  EXPECT_THAT(table, testing::Not(HasSubstr("warning")));
  EXPECT_THAT(run_program({"eval", file, estimate_}).output,
              HasSubstr("left out   1 poses of the reference: not finite"));
}

TEST(EvalCommandOnData, GivesTheFiguresOfEvo) {
  CVO_SLAM_REQUIRE_DATA("trajectories/freiburg1_xyz-rgbdslam.txt");
  const auto folder = test_data() / "trajectories";
  const auto result = run_program({"eval", folder / "freiburg1_xyz-groundtruth.txt",
                                   folder / "freiburg1_xyz-rgbdslam.txt", "--align", "sim3",
                                   "--max-diff", "0.01", "--json"});
  const auto json = nlohmann::json::parse(result.output);
  // Line 3 of EVO_REFERENCE.txt; the other lines are tested without the program.
  EXPECT_EQ(json["matches"], 785);
  EXPECT_NEAR(json["scale"].get<double>(), 1.008001390, 1e-6);
  EXPECT_NEAR(json["ate"]["translation_m"]["rmse"].get<double>(), 0.013389385, 1e-6);
  EXPECT_NEAR(json["ate"]["rotation_deg"]["rmse"].get<double>(), 2.057699602, 1e-6);
}

}  // namespace
}  // namespace cvo_slam
