// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Maps from outside: `run --save-map`, `--load-map` and `--localize`, `info <map>`.
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cvo_slam/core/files.h"
#include "cvo_slam/io/map_files.h"
#include "cvo_slam/tests/apps/room_sequence.h"
#include "cvo_slam/tests/apps/run_program.h"

namespace cvo_slam {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

class MapRun : public testing::Test {
 protected:
  [[nodiscard]] ProgramResult run(const std::string& out,
                                  const std::vector<std::string>& options) const {
    std::vector<std::string> arguments = {"run", sequence_, "--out", folder_.path() / out};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_program(arguments);
  }
  [[nodiscard]] nlohmann::json report_of(const std::string& out) const {
    return nlohmann::json::parse(read_file(folder_.path() / out / "report.json"));
  }
  void make_map() const {
    const auto result = run("first", {"--save-map", "--quiet"});
    ASSERT_EQ(result.exit_code, 0) << result.errors;
  }

  RoomSequence room_{12};
  const TemporaryFolder& folder_ = room_.folder();
  const fs::path sequence_ = room_.path();
  const fs::path map_ = folder_.path() / "first" / "map";
};

TEST_F(MapRun, AMapIsSavedDescribedAndGoneOnFrom) {
  make_map();
  const auto info = run_program({"info", map_});
  EXPECT_EQ(info.exit_code, 0) << info.errors;
  EXPECT_THAT(info.output, AllOf(HasSubstr("map of cvo_slam"), HasSubstr("in 1 submap\n")));
  const auto json = nlohmann::json::parse(run_program({"info", map_, "--json"}).output);
  const Map first = read_map(map_);
  EXPECT_EQ(json["keyframes"], first.keyframes.size());
  EXPECT_EQ(json["points"], report_of("first")["map"]["points"]);
  EXPECT_TRUE(report_of("first")["localized_frames"].is_null());

  const auto second = run("second", {"--load-map", map_, "--save-map"});
  EXPECT_EQ(second.exit_code, 0) << second.errors;
  EXPECT_THAT(second.output, HasSubstr("localized"));
  EXPECT_TRUE(report_of("second")["localized_frames"].is_number());
  const Map both = read_map(folder_.path() / "second" / "map");
  EXPECT_EQ(both.keyframes.size(), 2 * first.keyframes.size());
  EXPECT_GT(both.points.size(), first.points.size());
  // The same stamps twice: only the graph has the keyframes of the run's own files.
  EXPECT_FALSE(fs::exists(folder_.path() / "second" / "keyframes.txt"));
  EXPECT_EQ(
      run_program({"render", folder_.path() / "second", "-o", folder_.path() / "a.png"}).exit_code,
      0);
  EXPECT_EQ(run_program({"render", map_, "-o", folder_.path() / "b.png"}).exit_code, 0);
}

TEST_F(MapRun, LocalizingLeavesTheMapAsItIs) {
  make_map();
  const std::string before = read_file(map_ / "map.yaml");
  const auto result = run("second", {"--load-map", map_, "--localize", "--quiet"});
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(read_file(map_ / "map.yaml"), before);
  EXPECT_FALSE(fs::exists(folder_.path() / "second" / "map"));
  EXPECT_EQ(report_of("second")["graph"]["nodes"], read_map(map_).keyframes.size());
}

TEST_F(MapRun, ArgumentsThatDoNotFitAreErrors) {
  make_map();
  expect_error(run("x", {"--localize"}), 2, "--load-map <folder>");
  expect_error(run("x", {"--load-map", map_, "--localize", "--save-map"}), 2, "none to save");
  expect_error(run("x", {"--load-map", map_, "--mode", "graph"}), 2, "--mode slam");
  expect_error(run("x", {"--save-map", "--mode", "odometry"}), 2, "not odometry");
  expect_error(run("x", {"--load-map", folder_.path() / "first"}), 2, "for pictures only");
  expect_error(run("x", {"--load-map", folder_.path() / "none"}), 2, "none");
  EXPECT_FALSE(fs::exists(folder_.path() / "x")) << "nothing is made before that is known";
}

TEST_F(MapRun, AnotherCameraIsRefused) {
  make_map();
  std::string camera = read_file(sequence_ / "camera.yaml");
  const std::size_t at = camera.find("\nfx: ") + 5;
  camera.insert(at, "1");
  camera.insert(at, "1");
  camera.erase(at + 2, 2);
  write_file(sequence_ / "camera.yaml", camera);
  expect_error(run("x", {"--load-map", map_}), 2, "another camera");
}

TEST_F(MapRun, AMapOfModeGraphCannotBeGoneOnFrom) {
  const auto result = run("first", {"--save-map", "--mode", "graph", "--quiet"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  expect_error(run("x", {"--load-map", map_, "--quiet"}), 1, "without place recognition");
}

}  // namespace
}  // namespace cvo_slam
