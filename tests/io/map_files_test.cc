// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/io/map_files.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/tests/temporary_folder.h"

namespace cvo_slam {
namespace {

using testing::HasSubstr;

/// Keyframes 0, 10 and 20, a metre apart, in a loop.
Map small_map() {
  Map map;
  for (int i = 0; i < 3; ++i) {
    const SE3 pose(Matrix3::Identity(), {1.0 * i, 0, 0});
    map.keyframes.push_back({Timestamp::from_seconds(i), pose});
    map.graph.add_node({NodeId{10} * i, pose, i == 0});
  }
  const SE3 step(Matrix3::Identity(), {1, 0, 0});
  map.graph.add_edge({0, 10, step});
  map.graph.add_edge({10, 20, step, Matrix6::Identity(), EdgeKind::kProximity, true});
  map.graph.add_edge({0, 20, step * step, Matrix6::Identity(), EdgeKind::kLoop, true});
  map.points.push_back({{1, 2, 3}, {0, 0, 1}, {4, 5, 6}});
  return map;
}

class MapFiles : public testing::Test {
 protected:
  [[nodiscard]] std::string error_of_reading() const {
    try {
      static_cast<void>(read_map(folder_.path()));
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }

  TemporaryFolder folder_;
};

TEST_F(MapFiles, WhatIsWrittenReadsBackTheSame) {
  const Map map = small_map();
  write_map(folder_.path() / "new", map);
  const Map again = read_map(folder_.path() / "new");
  ASSERT_EQ(again.keyframes.size(), 3U);
  EXPECT_EQ(again.keyframes[2].stamp, map.keyframes[2].stamp);
  EXPECT_EQ(again.keyframes[2].T_world_camera.translation(), Vector3(2, 0, 0));
  ASSERT_EQ(again.graph.edges().size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(again.graph.edges()[i].kind, map.graph.edges()[i].kind) << i;
    EXPECT_EQ(again.graph.edges()[i].robust, map.graph.edges()[i].robust) << i;
  }
  EXPECT_TRUE(again.graph.nodes()[0].fixed);
  ASSERT_EQ(again.points.size(), 1U);
  EXPECT_EQ(again.points[0].position, Eigen::Vector3f(1, 2, 3));
}

TEST_F(MapFiles, PointsFarFromZeroReadBackWhereTheyWere) {
  Map map = small_map();
  map.points_origin = {400000, 5000000, 0};
  map.points[0].position = {0.01F, 0, 0};
  write_map(folder_.path(), map);
  const Map again = read_map(folder_.path());
  EXPECT_EQ(again.points_origin, map.points_origin);
  EXPECT_NEAR(again.points.at(0).position.x(), 0.01, 1e-8);
}

TEST_F(MapFiles, ForeignEntriesOfTheGraphAreNotedOrRefused) {
  write_map(folder_.path(), small_map());
  folder_.write("graph.g2o", read_text(folder_.path() / "graph.g2o") + "PARAMS_X 0\n");
  std::vector<std::string> notes;
  EXPECT_EQ(read_map(folder_.path(), notes).graph.nodes().size(), 3U);
  EXPECT_THAT(notes, testing::ElementsAre(HasSubstr("graph.g2o: 1 line PARAMS_X skipped")));
  EXPECT_THAT(error_of_reading(), HasSubstr("PARAMS_X: parameters are not read"));
}

TEST_F(MapFiles, AMapOfPosesAloneIsOne) {
  Map map = small_map();
  map.graph = {};
  map.points.clear();
  write_map(folder_.path(), map);
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "graph.g2o"));
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "map.ply"));
  EXPECT_EQ(read_map(folder_.path()).keyframes.size(), 3U);
}

TEST_F(MapFiles, FoldersWithoutAMapAreErrors) {
  EXPECT_THAT(error_of_reading(),
              HasSubstr("holds no map: none of keyframes.txt, graph.g2o and map.ply; give a folder "
                        "that cvo_slam run has written"));
  EXPECT_THROW(static_cast<void>(read_map(folder_.path() / "none")), InputError);
}

TEST_F(MapFiles, FilesOfDifferentMapsAreErrors) {
  write_map(folder_.path(), small_map());
  folder_.write("edges.txt", "0 10 odometry\n10 20 proximity\n");
  EXPECT_THAT(error_of_reading(), HasSubstr("edges.txt: 2 edges, but 3 in graph.g2o"));
  folder_.write("edges.txt", "0 10 odometry\n10 30 proximity\n0 20 loop\n");
  EXPECT_THAT(error_of_reading(),
              HasSubstr("edges.txt:2: expected '10 20 <kind>' as in graph.g2o"));
  folder_.write("edges.txt", "0 10 odometry\n10 20 nearness\n0 20 loop\n");
  EXPECT_THAT(error_of_reading(), HasSubstr("edges.txt:2: 'nearness' is no kind of edge"));
  write_map(folder_.path(), small_map());
  folder_.write("keyframes.txt", "0 0 0 0 0 0 0 1\n");
  EXPECT_THAT(error_of_reading(), HasSubstr("1 keyframes in keyframes.txt, but 3 nodes"));
}

TEST_F(MapFiles, AGraphOfOtherNodesIsNotWritten) {
  Map map = small_map();
  map.keyframes.pop_back();
  EXPECT_THROW(write_map(folder_.path(), map), DataError);
}

}  // namespace
}  // namespace cvo_slam
