// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cvo_slam/apps/benchmark_report.h"
#include "cvo_slam/apps/odometry_benchmark.h"
#include "cvo_slam/apps/report_json.h"
#include "cvo_slam/io/trajectory_files.h"
#include "cvo_slam/synthetic/sequence.h"
#include "cvo_slam/tests/apps/room_sequence.h"
#include "cvo_slam/tests/apps/run_program.h"
#include "cvo_slam/tests/io/tiny_sequence.h"

namespace cvo_slam {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

class BenchCommand : public testing::Test {
 protected:
  [[nodiscard]] ProgramResult bench(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"bench", "odometry", sequence_.string(), "--quiet"});
    return run_program(arguments);
  }

  RoomSequence room_{6};
  const TemporaryFolder& folder_ = room_.folder();
  const std::filesystem::path sequence_ = room_.path();
};

TEST_F(BenchCommand, ComparesAllSystemsOnAllFrames) {
  const ProgramResult result = bench({"--json"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const auto json = nlohmann::json::parse(result.output);
  std::vector<std::string> names;
  // The error of a system that stands still: the length of the motion between two frames.
  const double step = path_length(read_tum(sequence_ / "groundtruth.txt")) / 5;
  for (const auto& system : json["systems"]) {
    SCOPED_TRACE(system["name"]);
    names.push_back(system["name"]);
    if (!system["built_in"]) continue;
    EXPECT_EQ(system["lost"], 0);
    EXPECT_GT(system["cpu_ms"]["median"], 0);
    EXPECT_EQ(system["evaluation"]["matches"], 6);
    // A motion taken in the wrong direction gives twice the step.
    EXPECT_LT(system["evaluation"]["rpe"][1]["error"]["translation_m"]["rmse"], step);
  }
  EXPECT_EQ(names, odometry_system_names());
}

TEST_F(BenchCommand, PrintsATableWithARowForEachSystemAskedFor) {
  const ProgramResult result = bench({"--systems", "icp,ours", "--frames", "1:4"});
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(result.output, StartsWith("- sequence: room (TUM RGB-D), frames 1 to 3 of 6"));
  EXPECT_THAT(result.output, AllOf(HasSubstr("\n| icp "), HasSubstr("\n| ours ")));
  EXPECT_LT(result.output.find("\n| icp "), result.output.find("\n| ours "));
  EXPECT_THAT(result.output, testing::Not(HasSubstr("\n| paper ")));
}

TEST_F(BenchCommand, WritesTheTrajectories) {
  const auto out = folder_.path() / "new" / "out";
  EXPECT_EQ(bench({"--systems", "ours", "--out", out.string()}).exit_code, 0);
  EXPECT_EQ(read_tum(out / "ours.txt").size(), 6);
}

TEST_F(BenchCommand, DrawsDistributionsAndTopViews) {
  const auto plots = folder_.path() / "new" / "plots";
  const ProgramResult result = bench({"--systems", "ours,icp", "--plot", plots.string()});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(read_text(plots / "odometry.png"), StartsWith("\x89PNG"));
  const std::string svg = read_text(plots / "odometry.svg");
  EXPECT_THAT(svg, AllOf(HasSubstr(">Translation<"), HasSubstr(">Rotation<"), HasSubstr(">ours<"),
                         HasSubstr(">ground truth<"), HasSubstr(">share of frames<")));
  EXPECT_THAT(svg, testing::Not(HasSubstr("no data")));
}

TEST_F(BenchCommand, PlotsThatCannotBeMadeAreKnownBeforeTheWork) {
  const std::string file = folder_.write("file", "");
  const ProgramResult unwritable = bench({"--plot", file + "/plots"});
  EXPECT_EQ(unwritable.exit_code, 1);
  EXPECT_THAT(unwritable.errors, AllOf(StartsWith("cvo_slam: error: "), HasSubstr(file)));
  std::filesystem::remove(sequence_ / "groundtruth.txt");
  const ProgramResult without_truth = bench({"--plot", (folder_.path() / "plots").string()});
  EXPECT_EQ(without_truth.exit_code, 2);
  EXPECT_EQ(without_truth.errors,
            "cvo_slam: error: --plot: room has no ground truth to draw errors from; leave it out, "
            "or take a sequence that has one\n");
}

TEST_F(BenchCommand, RefusesAnUnknownSystemAndNamesTheNearest) {
  const ProgramResult result = bench({"--systems", "ours,rgdb"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.errors,
            "cvo_slam: error: --systems: unknown system 'rgdb'; did you mean 'rgbd'?\n");
}

TEST_F(BenchCommand, RefusesThreadsWhoseTimeItDoesNotSee) {
  const ProgramResult result = bench({"--threads", "2"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.errors, HasSubstr("single threads"));
  // The option may have come from a configuration file: it is named too.
  EXPECT_THAT(bench({"--set", "tracker.threads=2"}).errors,
              AllOf(HasSubstr("tracker.threads=2"), HasSubstr("--threads")));
}

TEST_F(BenchCommand, RefusesASystemNamedTwice) {
  const ProgramResult result = bench({"--systems", "ours,icp,ours"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.errors,
            "cvo_slam: error: --systems: 'ours' is named twice; name each system once\n");
}

TEST(BenchCommandLine, RefusesAMissingDatasetInOneLine) {
  const ProgramResult result = run_program({"bench", "odometry", "/nowhere"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.errors, StartsWith("cvo_slam: error: /nowhere"));
  EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1);
}

TEST_F(BenchCommand, VariantsRunOursWithOptionsThatDifferALittle) {
  const ProgramResult result =
      run_program({"bench", "variants", sequence_.string(), "--quiet", "--json", "--mode", "graph",
                   "--variants", "defaults,points-5%"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const auto systems = nlohmann::json::parse(result.output)["systems"];
  ASSERT_EQ(systems.size(), 2U);
  EXPECT_EQ(systems[0]["name"], "defaults");
  EXPECT_EQ(systems[1]["name"], "points-5%");
  EXPECT_GE(systems[0]["finish_cpu_ms"], 0);
}

TEST_F(BenchCommand, RefusesAnUnknownVariantAndNamesTheNearest) {
  const ProgramResult result =
      run_program({"bench", "variants", sequence_.string(), "--variants", "points-5"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.errors,
            "cvo_slam: error: --variants: unknown variant 'points-5'; did you mean 'points-5%'?\n");
}

/// Loses the second of two frames, and knows its pose at the end.
class LateSystem final : public OdometrySystem {
 public:
  std::optional<SE3> track(const RgbdFrame& frame) override {
    path_.poses.push_back({frame.stamp, SE3(Matrix3::Identity(), {0, 0, 7})});
    if (path_.poses.size() == 2) return std::nullopt;
    return SE3();
  }
  std::optional<Trajectory> finish() override { return path_; }

 private:
  Trajectory path_;
};

TEST(BenchCommandLine, AsksForTheComparison) {
  const ProgramResult result = run_program({"bench"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.errors, HasSubstr("a command is required: odometry"));
}

/// Returns the given poses, one for each frame.
class ScriptedSystem final : public OdometrySystem {
 public:
  explicit ScriptedSystem(std::vector<std::optional<SE3>> answers) : answers_(std::move(answers)) {}
  std::optional<SE3> track(const RgbdFrame& /*frame*/) override { return answers_.at(next_++); }

 private:
  std::vector<std::optional<SE3>> answers_;
  std::size_t next_ = 0;
};

class OdometryBenchmarkTest : public testing::Test {
 protected:
  void SetUp() override { sequence_.write_tum(); }

  [[nodiscard]] OdometryBenchmark run(std::unique_ptr<OdometrySystem> system) const {
    std::vector<Contestant> contestants;
    contestants.push_back({"scripted", "a test", std::move(system)});
    return run_odometry_benchmark(*sequence_.open(), {0, 2}, contestants);
  }

  TinySequence sequence_;
};

TEST_F(OdometryBenchmarkTest, ALostFrameKeepsThePoseBeforeIt) {
  const SE3 pose(Matrix3::Identity(), {1, 2, 3});
  const auto benchmark =
      run(std::make_unique<ScriptedSystem>(std::vector<std::optional<SE3>>{pose, std::nullopt}));
  const ContestantResult& result = benchmark.results.at(0);
  EXPECT_EQ(result.lost, 1);
  ASSERT_EQ(result.poses.size(), 2);
  EXPECT_EQ(result.poses[1].T_world_camera.translation(), pose.translation());
  EXPECT_EQ(result.cpu.count, 2);
  EXPECT_EQ(benchmark.decoding.count, 2);
}

TEST_F(OdometryBenchmarkTest, ThePathKnownAtTheEndReplacesThatOfTracking) {
  const auto benchmark = run(std::make_unique<LateSystem>());
  const ContestantResult& result = benchmark.results.at(0);
  EXPECT_EQ(result.lost, 0U);
  ASSERT_EQ(result.poses.size(), 2U);
  EXPECT_EQ(result.poses[0].T_world_camera.translation().z(), 7);
  EXPECT_EQ(result.poses[1].T_world_camera.translation().z(), 7);
}

TEST_F(OdometryBenchmarkTest, AWrongFrameIsCountedAndALostOneIsNot) {
  sequence_.write("groundtruth.txt",
                  "0.00 0 0 0 0 0 0 1\n0.05 0 0 0 0 0 0 1\n0.10 0 0 0 0 0 0 1\n");
  const SE3 away(Matrix3::Identity(), {1, 0, 0});
  const auto slipped =
      run(std::make_unique<ScriptedSystem>(std::vector<std::optional<SE3>>{SE3(), away}));
  const auto& wrong = slipped.results.at(0).wrong;
  ASSERT_TRUE(wrong);
  EXPECT_EQ(wrong->checked, 2U);
  ASSERT_EQ(wrong->frames.size(), 1U);
  EXPECT_NEAR(wrong->frames[0].translation, 1, 1e-9);
  const auto json = nlohmann::json::parse(json_text(*sequence_.open(), slipped));
  EXPECT_EQ(json["systems"][0]["wrong"]["frames"].size(), 1U);

  const auto lost =
      run(std::make_unique<ScriptedSystem>(std::vector<std::optional<SE3>>{SE3(), std::nullopt}));
  ASSERT_TRUE(lost.results.at(0).wrong);
  EXPECT_EQ(lost.results.at(0).wrong->checked, 1U);
  EXPECT_TRUE(lost.results.at(0).wrong->frames.empty());
}

TEST_F(OdometryBenchmarkTest, WithoutAReferenceTheTableHasNoErrors) {
  const auto benchmark =
      run(std::make_unique<ScriptedSystem>(std::vector<std::optional<SE3>>{SE3(), SE3()}));
  EXPECT_FALSE(benchmark.results.at(0).evaluation);
  EXPECT_THAT(
      to_table(*sequence_.open(), benchmark),
      testing::ContainsRegex("\\| scripted \\| +- \\| +- \\| +- \\| +- \\| +- \\| +0 \\| +- \\|"));
}

TEST_F(OdometryBenchmarkTest, ASystemThatIsNotBuiltInSaysSo) {
  const auto benchmark = run(nullptr);
  EXPECT_THAT(to_table(*sequence_.open(), benchmark), HasSubstr("| scripted | not built in |"));
  EXPECT_EQ(
      nlohmann::json::parse(json_text(*sequence_.open(), benchmark))["systems"][0]["built_in"],
      false);
}

}  // namespace
}  // namespace cvo_slam
