// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The folder of a map that Slam can go on from.
#include <cmath>
#include <csignal>
#include <filesystem>
#include <map>
#include <random>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/io/map_files.h"
#include "cvo_slam/tests/temporary_folder.h"

namespace cvo_slam {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

/// Three keyframes; `content` tells one map from another.
Map map_with(char content) {
  Map map;
  MapMemory& memory = map.memory.emplace();
  memory.camera.name = "mine";
  memory.camera.color.fx = 517.3;
  memory.cos_theta_sum = 1.7;
  memory.cos_theta_count = 2;
  memory.vocabulary = 0x12345678;
  for (int i = 0; i < 3; ++i) {
    const SE3 pose(so3_exp({0, 0.1 * i, 0}), {1.0 / 3 * i, 0, 0});
    // Two sessions: stamps do not ascend.
    const Timestamp stamp = Timestamp::from_seconds(10 - i);
    map.keyframes.push_back({stamp, pose});
    map.graph.add_node({NodeId{10} * i, pose});
    memory.keyframes.push_back({static_cast<std::size_t>(10 * i), stamp, i / 2,
                                std::string(20'000, content), std::string(5'000, content)});
  }
  const SE3 step(so3_exp({0, 0.1, 0}), {1.0 / 3, 0, 0});
  map.graph.add_edge({0, 10, step});
  map.graph.add_edge({10, 20, step, Matrix6::Identity(), EdgeKind::kLoop, true});
  map.points.push_back({{1, 2, 3}, {0, 0, 1}, {4, 5, 6}});
  return map;
}

std::map<std::string, std::string> files_of(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    files[entry.path().filename()] = read_file(entry.path());
  }
  return files;
}

class MapMemoryFiles : public testing::Test {
 protected:
  [[nodiscard]] std::string error_of_reading() const {
    try {
      static_cast<void>(read_map(map_));
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }
  void replace_in(const std::string& name, const std::string& old, const std::string& text) const {
    std::string bytes = read_file(map_ / name);
    bytes.replace(bytes.find(old), old.size(), text);
    write_file(map_ / name, bytes);
  }

  TemporaryFolder folder_;
  fs::path map_ = folder_.path() / "map";
};

TEST_F(MapMemoryFiles, SavedLoadedAndSavedTheyAreTheSameBytes) {
  write_map(map_, map_with('a'));
  const Map map = read_map(map_);
  ASSERT_TRUE(map.memory);
  EXPECT_EQ(map.memory->camera.color.fx, 517.3);
  EXPECT_EQ(map.memory->keyframes[2].number, 20U);
  EXPECT_EQ(map.memory->keyframes[2].submap, 1);
  EXPECT_EQ(map.memory->keyframes[2].points, std::string(20'000, 'a'));
  EXPECT_EQ(map.memory->vocabulary, 0x12345678U);
  EXPECT_EQ(map.keyframes[2].stamp, Timestamp::from_seconds(8));
  EXPECT_EQ(map.graph.edges()[1].kind, EdgeKind::kLoop);
  const auto files = files_of(map_);
  write_map(folder_.path() / "again", map);
  EXPECT_EQ(files_of(folder_.path() / "again"), files);
  EXPECT_EQ(files.size(), 7U);
}

// The surface only serves pictures: a few bytes a point, but no more is lost with every run.
TEST_F(MapMemoryFiles, TheirSurfaceIsRoundedOnce) {
  Map map = map_with('a');
  map.points.clear();
  map.points_origin = {4e5, 5e6, 0};
  std::mt19937 random(3);
  std::uniform_real_distribution<float> unit(-1, 1);
  for (int i = 0; i < 5000; ++i) {
    const float size = i % 100 == 0 ? 900 : 3;
    MapPoint& point = map.points.emplace_back();
    point.position = size * Eigen::Vector3f(unit(random), unit(random), unit(random));
    if (i % 10 != 0) {
      point.normal = Eigen::Vector3f(unit(random), unit(random), unit(random)).normalized();
    }
    point.color = {static_cast<std::uint8_t>(i % 256), 255, 0};
  }
  write_map(map_, map);
  const Map again = read_map(map_);
  ASSERT_EQ(again.points.size(), map.points.size());
  EXPECT_EQ(again.points_origin, map.points_origin);
  for (std::size_t i = 0; i < map.points.size(); ++i) {
    const MapPoint& before = map.points[i];
    const MapPoint& after = again.points[i];
    EXPECT_LT((after.position - before.position).cwiseAbs().maxCoeff(), 0.51F / 1024) << i;
    EXPECT_NEAR(after.color[0], before.color[0], 7) << i;
    EXPECT_EQ(after.color[1], 255) << i;
    EXPECT_EQ(after.normal.isZero(), before.normal.isZero()) << i;
    if (before.normal.isZero()) continue;
    EXPECT_GT(after.normal.dot(before.normal), std::cos(0.02)) << i;
  }
  const auto files = files_of(map_);
  write_map(map_, again);
  EXPECT_EQ(files_of(map_), files);
}

TEST_F(MapMemoryFiles, TakeThePlaceOfAnEarlierMapAsAWhole) {
  write_map(map_, map_with('a'));
  Map without_points = map_with('b');
  without_points.points.clear();
  write_map(map_, without_points);
  EXPECT_FALSE(fs::exists(map_ / "surface.bin"));
  EXPECT_EQ(read_map(map_).memory->keyframes[0].points[0], 'b');
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), {}), 1)
      << "nothing is left aside";
}

TEST_F(MapMemoryFiles, FoldersOfOthersAreNotReplaced) {
  folder_.write("map/thesis.tex", "ten years of work");
  EXPECT_THROW(write_map(map_, map_with('a')), OutputError);
  EXPECT_EQ(read_file(map_ / "thesis.tex"), "ten years of work");
}

TEST_F(MapMemoryFiles, AFlippedBitIsFound) {
  write_map(map_, map_with('a'));
  for (const auto& [name, bytes] : files_of(map_)) {
    if (name == "map.yaml") continue;
    std::string flipped = bytes;
    flipped[bytes.size() / 2] ^= 1;
    write_file(map_ / name, flipped);
    EXPECT_THAT(error_of_reading(), AllOf(HasSubstr(name), HasSubstr("damaged")));
    write_file(map_ / name, bytes);
  }
  EXPECT_EQ(error_of_reading(), "no error");
}

TEST_F(MapMemoryFiles, MissingFilesAndOtherVersionsAreNamed) {
  write_map(map_, map_with('a'));
  replace_in("map.yaml", "format: 3", "format: 4");
  EXPECT_THAT(error_of_reading(), AllOf(HasSubstr("map.yaml:2"), HasSubstr("format 4")));
  replace_in("map.yaml", "format: 4", "format: 3");
  fs::remove(map_ / "keyframes.bin");
  EXPECT_THAT(error_of_reading(), HasSubstr("keyframes.bin"));
  replace_in("map.yaml", "  keyframes.bin:", "  keyframes_bin:");
  EXPECT_THAT(error_of_reading(), AllOf(HasSubstr("map.yaml"), HasSubstr("keyframes.bin")));
}

/// Runs `work` in a process of its own and returns how it ended.
template <typename Work>
int status_of_child(const Work& work, int kill_after_us = -1) {
  const pid_t child = fork();
  if (child == 0) {
    work();
    _exit(0);
  }
  if (kill_after_us >= 0) {
    usleep(static_cast<useconds_t>(kill_after_us));
    kill(child, SIGKILL);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return status;
}

// Whatever happens while a map is written, the old one or the new one is there.
TEST_F(MapMemoryFiles, SurviveTwoHundredKills) {
  const Map a = map_with('a');
  const Map b = map_with('b');
  write_map(map_, a);
  std::mt19937 random(3);
  std::uniform_int_distribution<int> microseconds(0, 6000);
  int killed = 0;
  for (int i = 0; i < 200; ++i) {
    const int status = status_of_child(
        [&] {
          for (int k = 0; k < 50; ++k) write_map(map_, k % 2 == 0 ? b : a);
        },
        microseconds(random));
    killed += WIFSIGNALED(status) ? 1 : 0;
    const Map map = read_map(map_);
    const char content = map.memory->keyframes[0].points[0];
    ASSERT_TRUE(content == 'a' || content == 'b');
    ASSERT_EQ(map.memory->keyframes[2].features, std::string(5'000, content)) << i;
  }
  EXPECT_GT(killed, 150);
  write_map(map_, a);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), {}), 1)
      << "what the killed ones left is gone";
}

// A limit on the size of files is a disk that is full at that point.
TEST_F(MapMemoryFiles, SurviveAFullDisk) {
  Map large = map_with('b');
  std::mt19937 random(3);
  for (KeyframeMemory& keyframe : large.memory->keyframes) {
    for (char& byte : keyframe.points) byte = static_cast<char>(random());  // does not compress
  }
  write_map(map_, map_with('a'));
  const auto before = files_of(map_);
  int refused = 0;
  for (int i = 0; i < 100; ++i) {
    const int status = status_of_child([&] {
      std::signal(SIGXFSZ, SIG_IGN);
      const rlimit limit = {static_cast<rlim_t>(600 * i), static_cast<rlim_t>(600 * i)};
      setrlimit(RLIMIT_FSIZE, &limit);
      try {
        write_map(map_, large);
      } catch (const OutputError&) {
        _exit(1);
      }
    });
    ASSERT_TRUE(WIFEXITED(status));
    if (WEXITSTATUS(status) == 0) continue;
    ++refused;
    ASSERT_EQ(files_of(map_), before) << i;
  }
  EXPECT_EQ(refused, 100);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), {}), 1)
      << "nothing is left aside";
}

}  // namespace
}  // namespace cvo_slam
