// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// `cvo_slam run` from outside: the files it leaves, its exit codes, its errors.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "cvo_slam/io/map_files.h"
#include "cvo_slam/io/trajectory_files.h"
#include "cvo_slam/synthetic/sequence.h"
#include "cvo_slam/tests/apps/room_sequence.h"
#include "cvo_slam/tests/apps/run_program.h"
#include "cvo_slam/tests/temporary_folder.h"

namespace cvo_slam {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr std::size_t kFrames = 12;

class RunCommand : public testing::Test {
 protected:
  [[nodiscard]] ProgramResult run(const std::vector<std::string>& options,
                                  const std::string& out = "out",
                                  const ProgramStreams& streams = {}) const {
    std::vector<std::string> arguments = {"run", sequence_, "--out", folder_.path() / out};
    if (std::find(options.begin(), options.end(), "--mode") == options.end()) {
      arguments.insert(arguments.end(), {"--mode", "odometry"});
    }
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_program(arguments, streams);
  }

  [[nodiscard]] bool has_file(const std::string& name) const {
    return std::filesystem::exists(folder_.path() / "out" / name);
  }

  void expect_every_file() const {
    for (const char* name : {"trajectory.txt", "trajectory_online.txt", "frames.csv", "config.yaml",
                             "report.json", "report.html", "trajectory.png", "trajectory.svg",
                             "errors.png", "errors.svg", "keyframes.txt", "map.ply", "map.png"}) {
      ASSERT_TRUE(has_file(name)) << name;
      EXPECT_GT(file(name).size(), 100U) << name;
    }
  }

  [[nodiscard]] std::string file(const std::string& name, const std::string& out = "out") const {
    return read_text(folder_.path() / out / name);
  }

  RoomSequence room_{kFrames};
  const TemporaryFolder& folder_ = room_.folder();
  const std::filesystem::path sequence_ = room_.path();
};

TEST_F(RunCommand, WritesEveryFileAndEndsWithATable) {
  const auto result = run({});
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(result.output, AllOf(HasSubstr("ATE"), HasSubstr("RPE 1 frame"), HasSubstr("fps"),
                                   HasSubstr("lost         0.0 %"), HasSubstr("peak memory")));
  EXPECT_THAT(result.errors, HasSubstr("frame 12/12"));
  expect_every_file();
  EXPECT_EQ(read_tum(folder_.path() / "out" / "trajectory.txt").size(), kFrames);
  const std::string csv = file("frames.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), static_cast<long>(kFrames) + 1);
  EXPECT_THAT(csv, AllOf(HasSubstr(",points,registration,"), HasSubstr(",converged,")));
}

TEST_F(RunCommand, TheMapIsOfTheKeyframesAndCanBeLeftOut) {
  ASSERT_EQ(run({"--quiet"}).exit_code, 0);
  const auto report = nlohmann::json::parse(file("report.json"));
  EXPECT_EQ(report["map"]["keyframes"], report["frames"]["keyframes"]);
  const Map map = read_map(folder_.path() / "out");
  EXPECT_EQ(map.points.size(), report["map"]["points"]);
  // Every third pixel of a 160x120 image in each direction is a sample, and a point has two or
  // more.
  EXPECT_GT(map.points.size(), 200U);
  // The room is 5 m long (docs/reference/synthetic-worlds.md), and the map is in the first camera's
  // frame.
  for (const MapPoint& point : map.points) EXPECT_LT(point.position.norm(), 6);
  EXPECT_EQ(cv::imread(folder_.path() / "out" / "map.png").size(), cv::Size(1280, 720));

  ASSERT_EQ(run({"--quiet", "--no-map"}).exit_code, 0);
  EXPECT_FALSE(has_file("map.ply"));
  EXPECT_FALSE(has_file("map.png"));
  EXPECT_TRUE(has_file("keyframes.txt"));
}

TEST_F(RunCommand, ReportHoldsTheFiguresOfAnExactTracker) {
  ASSERT_EQ(run({"--quiet"}).exit_code, 0);
  const auto report = nlohmann::json::parse(file("report.json"));
  EXPECT_EQ(report["frames"]["tracked"], kFrames);
  EXPECT_EQ(report["frames"]["lost"], 0);
  // The pixels of a 160x120 image are 1.5 cm wide at 2 m: the path is followed to a fraction of
  // one.
  EXPECT_LT(report["evaluation"]["ate"]["translation_m"]["rmse"], 0.005);
  const auto& options = report["options"];
  EXPECT_EQ(options["expert.tracker.registration.solver"], "newton");
  EXPECT_TRUE(options["tracker.points"].is_number_integer());
  EXPECT_TRUE(options["tracker.registration.length_scales"][0].is_number());
}

TEST_F(RunCommand, SameBytesAgainAndWithTwoThreads) {
  for (const char* out : {"first", "again"}) ASSERT_EQ(run({"--quiet"}, out).exit_code, 0);
  ASSERT_EQ(run({"--quiet", "--threads", "2"}, "threads").exit_code, 0);
  for (const char* name :
       {"trajectory.txt", "trajectory_online.txt", "trajectory.svg", "map.ply"}) {
    EXPECT_EQ(file(name, "again"), file(name, "first")) << name;
    EXPECT_EQ(file(name, "threads"), file(name, "first")) << name;
  }
}

TEST_F(RunCommand, EffectiveConfigurationReproducesTheRun) {
  ASSERT_EQ(run({"--quiet", "--set", "tracker.points=300"}).exit_code, 0);
  ASSERT_EQ(run({"--quiet", "--config", folder_.path() / "out" / "config.yaml"}, "two").exit_code,
            0);
  EXPECT_EQ(file("config.yaml", "two"), file("config.yaml"));
  EXPECT_EQ(file("trajectory.txt", "two"), file("trajectory.txt"));
}

TEST_F(RunCommand, PaperPresetRunsToTheEnd) {
  const auto result = run({"--quiet", "--preset", "paper", "--frames", "0:4"});
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  const auto report = nlohmann::json::parse(file("report.json"));
  EXPECT_EQ(report["frames"]["tracked"], 4);
  EXPECT_EQ(report["options"]["expert.tracker.registration.solver"], "flow");
}

TEST_F(RunCommand, GraphModeWritesItsFilesToo) {
  const std::vector<std::string> options = {"--mode", "graph",
                                            "--set",  "tracker.keyframe.max_translation=0.01",
                                            "--set",  "tracker.keyframe.max_rotation=0.01"};
  const auto result = run(options);
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(result.output, AllOf(HasSubstr("ATE"), HasSubstr("proximity edges")));
  expect_every_file();
  EXPECT_EQ(read_tum(folder_.path() / "out" / "trajectory.txt").size(), kFrames);
  const auto report = nlohmann::json::parse(file("report.json"));
  EXPECT_EQ(report["mode"], "graph");
  const auto& graph = report["graph"];
  EXPECT_EQ(read_tum(folder_.path() / "out" / "keyframes.txt").size(), graph["nodes"]);
  EXPECT_THAT(file("graph.g2o"), HasSubstr("EDGE_SE3:QUAT"));
  const std::string csv = file("loops.csv");
  EXPECT_GT(graph["candidates"], 0);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), graph["candidates"].get<long>() + 1);

  std::vector<std::string> again = options;
  again.insert(again.end(), {"--threads", "2", "--set", "schedule=pipelined"});
  ASSERT_EQ(run(again, "again").exit_code, 0);
  for (const char* name :
       {"trajectory.txt", "trajectory_online.txt", "keyframes.txt", "graph.g2o", "loops.csv"}) {
    EXPECT_EQ(file(name, "again"), file(name)) << name;
  }
}

TEST_F(RunCommand, SlamModeRecognisesPlaces) {
  const auto result =
      run({"--mode", "slam", "--set", "tracker.keyframe.max_translation=0.01", "--set",
           "tracker.keyframe.max_rotation=0.01", "--set", "loops.detection.candidates.min_gap=3"});
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(result.output, HasSubstr("loop edges"));
  const auto report = nlohmann::json::parse(file("report.json"));
  EXPECT_EQ(report["mode"], "slam");
  EXPECT_EQ(report["options"]["loops.enabled"], true);
  EXPECT_GT(report["graph"]["bow_candidates"], 0);
  EXPECT_TRUE(report["graph"]["loop_edges"].is_number_integer());
  EXPECT_THAT(file("loops.csv"), AllOf(HasSubstr("kind,from,to,score,normalized_score,inliers,"),
                                       HasSubstr("\nbow,"), HasSubstr("\nproximity,")));
}

TEST_F(RunCommand, VocabularyIsForSlamModeAndMustBeOne) {
  folder_.write("broken.voc", "no vocabulary");
  const std::string file = folder_.path() / "broken.voc";
  expect_error(run({"--mode", "slam", "--vocabulary", file}), 2, "broken.voc");
  expect_error(run({"--mode", "graph", "--vocabulary", file}), 2, "--mode slam");
}

TEST_F(RunCommand, SlamIsTheModeWhereNoneIsGiven) {
  EXPECT_EQ(run_program({"run", sequence_, "--out", folder_.path() / "out", "--quiet"}).exit_code,
            0);
  EXPECT_EQ(nlohmann::json::parse(file("report.json"))["mode"], "slam");
  EXPECT_TRUE(has_file("graph.g2o"));
}

TEST_F(RunCommand, FramesTakesARange) {
  ASSERT_EQ(run({"--quiet", "--frames", "3:7"}).exit_code, 0);
  EXPECT_EQ(read_tum(folder_.path() / "out" / "trajectory.txt").size(), 4U);
  EXPECT_THAT(file("frames.csv"), HasSubstr("\n3,"));
  ASSERT_EQ(run({"--quiet", "--frames", "0:7:3"}).exit_code, 0);
  EXPECT_EQ(read_tum(folder_.path() / "out" / "trajectory.txt").size(), 3U);
}

TEST_F(RunCommand, JsonReplacesTheTable) {
  const auto result = run({"--json", "--quiet"});
  EXPECT_EQ(nlohmann::json::parse(result.output), nlohmann::json::parse(file("report.json")));
}

TEST_F(RunCommand, WithoutGroundTruthThereAreNoErrorsButEverythingElse) {
  std::filesystem::remove(sequence_ / "groundtruth.txt");
  const auto result = run({});
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(result.output, AllOf(HasSubstr("no ground truth"), Not(HasSubstr("ATE"))));
  EXPECT_GT(file("trajectory.png").size(), 1000U);
  EXPECT_FALSE(has_file("errors.png"));
}

TEST_F(RunCommand, AUsedFolderKeepsNothingOfTheRunBeforeAndAllElse) {
  ASSERT_EQ(run({"--quiet"}).exit_code, 0);
  ASSERT_TRUE(has_file("errors.png"));
  folder_.write("out/notes.txt", "mine");
  std::filesystem::remove(sequence_ / "groundtruth.txt");
  ASSERT_EQ(run({"--quiet"}).exit_code, 0);
  EXPECT_FALSE(has_file("errors.png"));
  EXPECT_FALSE(has_file("errors.svg"));
  EXPECT_EQ(file("notes.txt"), "mine");
}

TEST_F(RunCommand, AFullStderrDoesNotStopIt) {
  EXPECT_EQ(run({}, "out", {.errors = "/dev/full"}).exit_code, 0);
  expect_every_file();
}

TEST_F(RunCommand, AClosedStderrDoesNotStopIt) {
  const std::string command =
      fmt::format("'{}' run '{}' --out '{}' >/dev/null 2>&-", CVO_SLAM_PROGRAM, sequence_.string(),
                  (folder_.path() / "out").string());
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 0);
  expect_every_file();
}

TEST_F(RunCommand, AFullStdoutIsAnErrorAfterTheFiles) {
  expect_error(run({"--frames", "0:3", "--quiet", "--json"}, "out", {.output = "/dev/full"}), 1,
               "");
  EXPECT_GT(file("report.json").size(), 100U);
}

TEST_F(RunCommand, FiguresArePrintedEvenWhereAFileCannotBeWritten) {
  folder_.write("out/trajectory.png/file", "in the way");
  const auto result = run({"--frames", "0:3", "--overwrite"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.errors, HasSubstr("trajectory.png"));
  EXPECT_THAT(result.output, AllOf(HasSubstr("RPE 1 frame"), HasSubstr("fps")));
}

TEST_F(RunCommand, LostFramesAreMarkedAndTooManyAreExitCode3) {
  room_.blank(5, 5);
  const auto result = run({});
  EXPECT_EQ(result.exit_code, 3);  // 1 of 12 is more than 5 %
  EXPECT_THAT(result.output, HasSubstr("lost         8.3 % (1 of 12 frames)"));
  EXPECT_THAT(file("trajectory.txt"), HasSubstr("# lost 1000.166667 only 0 points"));
  EXPECT_EQ(read_tum(folder_.path() / "out" / "trajectory.txt").size(), kFrames - 1);
  EXPECT_EQ(run({"--max-lost", "0.1"}).exit_code, 0);
}

TEST_F(RunCommand, ABrokenImageIsALostFrameThatNamesTheFile) {
  folder_.write("room/rgb/1000.133333.png", "not an image");
  EXPECT_EQ(run({"--quiet"}).exit_code, 3);
  EXPECT_THAT(file("trajectory.txt"),
              AllOf(HasSubstr("# lost 1000.133333"), HasSubstr("rgb/1000.133333.png")));
}

TEST_F(RunCommand, NoFrameTrackedIsExitCode3WithAllFiles) {
  room_.blank(0, kFrames - 1);
  const auto result = run({});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.output, HasSubstr("lost         100.0 %"));
  EXPECT_GT(file("trajectory.png").size(), 1000U);
}

TEST_F(RunCommand, BadInputIsOneLineAndExitCode2) {
  expect_error(run({"--set", "tracker.pionts=5"}), 2, "did you mean 'tracker.points'?");
  expect_error(run({"--set", "tracker.points"}), 2, "key=value");
  expect_error(run({"--set", "tracker.points=many"}), 2, "tracker.points=many");
  expect_error(run({"--frames", "7:3"}), 2, "holds no frame");
  expect_error(run({"--frames", "x"}), 2, "a:b");
  expect_error(run({"--frames", "0:7:0"}), 2, "a:b:step");
  expect_error(run({"--mode", "magic"}), 2, "magic");
  expect_error(run({"--camera", "no_such.yaml"}), 2, "no_such.yaml");
  expect_error(run_program({"run"}), 2, "no dataset");
  expect_error(run_program({"run", folder_.path() / "nowhere"}), 2, "nowhere");
  const auto yaml = folder_.write("bad.yaml", "tracker:\n  points: [1\n");
  expect_error(run({"--config", yaml}), 2, "bad.yaml");
  const auto unknown = folder_.write("unknown.yaml", "tracker:\n  point: 1\n");
  expect_error(run({"--config", unknown}), 2, "unknown.yaml:2");
}

TEST_F(RunCommand, AnUnwritableFolderIsSaidBeforeTheWork) {
  const auto result = run_program({"run", sequence_, "--out", "/proc/cvo_slam"});
  expect_error(result, 1, "/proc/cvo_slam");
  EXPECT_THAT(result.errors, HasSubstr("choose another folder or check its permissions"));
  const auto file_in_the_way = folder_.write("file", "");
  expect_error(run_program({"run", sequence_, "--out", file_in_the_way}), 1, "file");
}

TEST_F(RunCommand, TheDefaultFolderHasALinkToTheLatest) {
  const auto here = std::filesystem::current_path();
  std::filesystem::current_path(folder_.path());
  // The runs are so short that most of them fall into the same second.
  for (int i = 0; i < 4; ++i) {
    const auto result = run_program({"run", sequence_, "--quiet", "--frames", "0:2"});
    EXPECT_EQ(result.exit_code, 0) << result.errors;
  }
  std::filesystem::current_path(here);
  const auto results = folder_.path() / "results" / "room";
  EXPECT_GT(read_text(results / "latest" / "report.json").size(), 100U);
  const std::filesystem::directory_iterator entries(results);
  EXPECT_EQ(std::distance(begin(entries), end(entries)), 5);  // four folders and the link
}

TEST_F(RunCommand, AnInterruptOrATerminationWritesWhatThereIs) {
  // The protocol of the paper takes seconds. The program is interrupted as soon as it has made its
  // folder, which it does after it began to listen. A program that makes none is interrupted after
  // a minute, and the test fails.
  for (const auto& [signal, code] : {std::pair("INT", 130), std::pair("TERM", 143)}) {
    const auto out = folder_.path() / signal;
    const std::string command = fmt::format(
        "'{0}' run '{1}' --out '{2}' --preset paper --quiet & for i in $(seq 6000); do "
        "[ -e '{2}/trajectory.txt' ] && break; sleep 0.01; done; kill -{3} $!; wait $!",
        CVO_SLAM_PROGRAM, sequence_.string(), out.string(), signal);
    const int status = std::system(command.c_str());
    EXPECT_EQ(WEXITSTATUS(status), code);
    const auto report = nlohmann::json::parse(file("report.json", signal));
    EXPECT_TRUE(report["interrupted"]);
    EXPECT_THAT(file("report.html", signal), HasSubstr("interrupted: results until then"));
    EXPECT_LT(report["frames"]["processed"], kFrames);
  }
}

TEST(DefaultConfiguration, FileIsWhatTheProgramPrints) {
  // To update the file: build/release/cvo_slam run --dump-config > config/default.yaml
  EXPECT_EQ(read_text(std::filesystem::path(CVO_SLAM_SOURCE_DIR) / "config" / "default.yaml"),
            run_program({"run", "--dump-config"}).output);
}

// More options than a user can read are no help: what is rarely changed is for experts.
TEST(DefaultConfiguration, HasAtMost45OptionsForEveryone) {
  const std::string page = read_text(std::filesystem::path(CVO_SLAM_SOURCE_DIR) / "docs" /
                                     "reference" / "options.md");  // tested against the code
  const std::string first = page.substr(0, page.find("## Options for experts"));
  std::size_t rows = 0;
  for (std::size_t at = first.find("\n| `"); at != std::string::npos;
       at = first.find("\n| `", at + 1)) {
    ++rows;
  }
  EXPECT_GT(rows, 30U);
  EXPECT_LE(rows, 45U);
}

}  // namespace
}  // namespace cvo_slam
