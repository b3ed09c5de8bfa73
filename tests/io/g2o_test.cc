// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/io/g2o.h"

#include <random>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/tests/temporary_folder.h"
#include "cvo_slam/tests/test_data.h"

namespace cvo_slam {
namespace {

const std::string kVertices = "VERTEX_SE3:QUAT 0 0 0 0 0 0 0 1\nVERTEX_SE3:QUAT 1 1 0 0 0 0 0 1\n";
const std::string kPose = "1 2 3 0 0 0 1";
const std::string kUnitInformation = " 1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 1 0 0 1 0 1";

class G2o : public testing::Test {
 protected:
  [[nodiscard]] PoseGraph read(const std::string& text) const {
    return read_g2o(folder_.write("graph.g2o", text));
  }

  /// Returns the message of the error that read_g2o throws for a text, without the folder.
  [[nodiscard]] std::string error_of(const std::string& text) const {
    try {
      static_cast<void>(read(text));
    } catch (const InputError& error) {
      return std::string(error.what()).substr((folder_.path() / "").string().size());
    }
    return "no error";
  }

  TemporaryFolder folder_;
};

TEST_F(G2o, ReadsVerticesEdgesAndFix) {
  const PoseGraph graph = read("# a comment\nEDGE_SE3:QUAT 7 -3 " + kPose + kUnitInformation +
                               "\nVERTEX_SE3:QUAT 7 1 2 3 0 0 0 2\r\n\nFIX -3\n"
                               "VERTEX_SE3:QUAT -3 0 0 0 0 0 1 0\n");
  ASSERT_EQ(graph.nodes().size(), 2);
  EXPECT_EQ(graph.nodes()[0].id, 7);
  EXPECT_EQ(graph.nodes()[0].T_world_node.translation(), Vector3(1, 2, 3));
  EXPECT_EQ(graph.nodes()[0].T_world_node.rotation(), Matrix3::Identity());  // normalised
  EXPECT_FALSE(graph.nodes()[0].fixed);
  EXPECT_TRUE(graph.nodes()[1].fixed);
  ASSERT_EQ(graph.edges().size(), 1);
  EXPECT_EQ(graph.ends()[0], std::make_pair(std::size_t{0}, std::size_t{1}));
  EXPECT_EQ(graph.edges()[0].information, Matrix6::Identity());
}

// Odometry from the newer to the older vertex was taken for loops, and robust losses threw it away.
TEST_F(G2o, OnlyEdgesBetweenNeighboursAreOdometryInEitherDirection) {
  const std::string end = " " + kPose + kUnitInformation + "\n";
  const PoseGraph graph = read(kVertices + "VERTEX_SE3:QUAT 2 2 0 0 0 0 0 1\nEDGE_SE3:QUAT 0 1" +
                               end + "EDGE_SE3:QUAT 2 1" + end + "EDGE_SE3:QUAT 2 0" + end);
  EXPECT_EQ(graph.edges()[0].kind, EdgeKind::kOdometry);
  EXPECT_FALSE(graph.edges()[0].robust);
  EXPECT_EQ(graph.edges()[1].kind, EdgeKind::kOdometry);
  EXPECT_FALSE(graph.edges()[1].robust);
  EXPECT_EQ(graph.edges()[2].kind, EdgeKind::kLoop);
  EXPECT_TRUE(graph.edges()[2].robust);
}

TEST_F(G2o, TheNextVertexIsTheOneWithTheNextLargerId) {
  const std::string end = " " + kPose + kUnitInformation + "\n";
  const PoseGraph graph = read(
      "VERTEX_SE3:QUAT 8 0 0 0 0 0 0 1\nVERTEX_SE3:QUAT 0 0 0 0 0 0 0 1\n"
      "VERTEX_SE3:QUAT 5 0 0 0 0 0 0 1\n"
      "EDGE_SE3:QUAT 0 5" +
      end + "EDGE_SE3:QUAT 8 5" + end + "EDGE_SE3:QUAT 0 8" + end);
  EXPECT_EQ(graph.edges()[0].kind, EdgeKind::kOdometry);
  EXPECT_EQ(graph.edges()[1].kind, EdgeKind::kOdometry);
  EXPECT_EQ(graph.edges()[2].kind, EdgeKind::kLoop);
}

TEST_F(G2o, InformationIsTheUpperTriangleByRows) {
  // Diagonally dominant. Each value names its place: row r, column c has the digits rc.
  std::string values;
  for (int row = 1; row <= 6; ++row) {
    for (int column = row; column <= 6; ++column) {
      values += fmt::format(" {}", row == column ? 1000 : 10 * row + column);
    }
  }
  const PoseGraph graph = read(kVertices + "EDGE_SE3:QUAT 0 1 " + kPose + values);
  const Matrix6& information = graph.edges()[0].information;
  for (int row = 1; row <= 6; ++row) {
    EXPECT_EQ(information(row - 1, row - 1), 1000);
    for (int column = row + 1; column <= 6; ++column) {
      EXPECT_EQ(information(row - 1, column - 1), 10 * row + column);
      EXPECT_EQ(information(column - 1, row - 1), 10 * row + column);
    }
  }
}

PoseGraph random_graph(int nodes) {
  std::mt19937 rng(3);
  std::normal_distribution<double> normal;
  const auto random_pose = [&] {
    Vector6 xi;
    for (int k = 0; k < 6; ++k) xi[k] = 2 * normal(rng);
    return SE3::exp(xi);
  };
  PoseGraph graph;
  graph.add_node({0, random_pose(), true});
  for (const Vector3& axis : {Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(0.6, 0, -0.8)}) {
    const Matrix3 half_turn = 2 * axis * axis.transpose() - Matrix3::Identity();
    graph.add_node({nodes + static_cast<NodeId>(graph.nodes().size()), SE3(half_turn, {0, 0, 0})});
  }
  for (int id = 1; id < nodes; ++id) {
    graph.add_node({id, random_pose()});
    Matrix6 root;
    for (double& value : root.reshaped()) value = normal(rng);
    const Matrix6 square = root * root.transpose();
    const Matrix6 symmetric = (square + square.transpose()) / 2;
    graph.add_edge({id - 1, id, random_pose(), symmetric});
  }
  return graph;
}

TEST_F(G2o, AWrittenFileReadsBackTheSame) {
  const PoseGraph graph = random_graph(2000);
  const auto first = folder_.path() / "first.g2o";
  const auto second = folder_.path() / "second.g2o";
  write_g2o(first, graph);
  const PoseGraph again = read_g2o(first);
  write_g2o(second, again);
  EXPECT_TRUE(read_text(first) == read_text(second));  // EXPECT_EQ would print megabytes
  for (std::size_t i = 0; i < graph.edges().size(); ++i) {
    EXPECT_EQ(again.edges()[i].information, graph.edges()[i].information);
  }
  for (std::size_t i = 0; i < graph.nodes().size(); ++i) {
    EXPECT_EQ(again.nodes()[i].fixed, graph.nodes()[i].fixed);
    EXPECT_EQ(again.nodes()[i].T_world_node.translation(),
              graph.nodes()[i].T_world_node.translation());
    // The digits of a quaternion: 14 after the point.
    EXPECT_LT((again.nodes()[i].T_world_node.rotation() - graph.nodes()[i].T_world_node.rotation())
                  .norm(),
              1e-13);
  }
}

TEST_F(G2o, BadInputIsNamedWithItsLine) {
  const std::string edge = "EDGE_SE3:QUAT 0 1 " + kPose;
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", "graph.g2o: no VERTEX_SE3:QUAT in it; is it a pose graph?"},
      {"VERTEX_SE3:QUAT 0 0 0 0 0 0 0",
       "graph.g2o:1: VERTEX_SE3:QUAT has 7 values, expected 8: id x y z qx qy qz qw; repair or "
       "remove the line"},
      {kVertices + edge + " 1 0 0",
       "graph.g2o:3: EDGE_SE3:QUAT has 12 values, expected 30: from to x y z qx qy qz qw and 21 of "
       "the information matrix; repair or remove the line"},
      {kVertices + "VERTEX_SE3:QUAT 1 0 0 0 0 0 0 1",
       "graph.g2o:3: node 1 exists already; ids must be unique"},
      {kVertices + "EDGE_SE3:QUAT 0 5 " + kPose + kUnitInformation,
       "graph.g2o:3: node 5 is unknown; add it first"},
      {kVertices + "EDGE_SE3:QUAT 1 1 " + kPose + kUnitInformation,
       "graph.g2o:3: edge 1 -> 1: both ends are the same node; remove it"},
      {kVertices + edge + " 1 0 0 0 0 0 1 0 0 0 0 -1 0 0 0 1 0 0 1 0 1",
       "graph.g2o:3: edge 0 -> 1: the information matrix has a negative eigenvalue; repair or "
       "remove the edge"},
      {kVertices + edge + " 1 0 0 0 0 0 1 0 0 0 0 nan 0 0 0 1 0 0 1 0 1",
       "graph.g2o:3: 'nan' is not a finite number; repair or remove the line"},
      {"VERTEX_SE3:QUAT 0 0 x 0 0 0 0 1",
       "graph.g2o:1: 'x' is not a finite number; repair or remove the line"},
      {"VERTEX_SE3:QUAT 0.5 0 0 0 0 0 0 1",
       "graph.g2o:1: '0.5' is not the number of a vertex; write a whole number"},
      {"VERTEX_SE3:QUAT 0 0 0 0 0 0 0 0",
       "graph.g2o:1: the quaternion has length zero; repair or remove the line"},
      {kVertices + "FIX 9", "graph.g2o:3: node 9 is unknown; add it first"},
      {kVertices + "FIX", "graph.g2o:3: FIX names no vertex; remove the line"},
      {"\nVERTEX_SE2 0 0 0 0",
       "graph.g2o:2: VERTEX_SE2: a planar graph; only 3D graphs are read, make it VERTEX_SE3:QUAT "
       "and EDGE_SE3:QUAT"},
      {kVertices + "EDGE_PRIOR_SE2_XY 0",
       "graph.g2o:3: EDGE_PRIOR_SE2_XY: a planar graph; only 3D graphs are read, make it "
       "VERTEX_SE3:QUAT and EDGE_SE3:QUAT"},
      {kVertices + "EDGE_SE3_OFFSET 0 1",
       "graph.g2o:3: unknown entry 'EDGE_SE3_OFFSET'; VERTEX_SE3:QUAT, EDGE_SE3:QUAT and FIX are "
       "read: remove the line"},
      {kVertices + "EDGE_SE3_PRIOR 0",
       "graph.g2o:3: EDGE_SE3_PRIOR: priors are not read; remove the line"},
      // More than rounding, which may be 5e-6 of the largest eigenvalue.
      {kVertices + edge + " 1 0 0 0 0 0 1 0 0 0 0 -1e-5 0 0 0 1 0 0 1 0 1",
       "graph.g2o:3: edge 0 -> 1: the information matrix has a negative eigenvalue; repair or "
       "remove the edge"},
  };
  for (const auto& [text, message] : cases) EXPECT_EQ(error_of(text), message) << text;
}

const std::string kForeign =
    "PARAMS_SE3OFFSET 0 0 0 0 0 0 0 1\n" + kVertices + "VERTEX_TRACKXYZ 7 1 2 3\n" +
    "EDGE_SE3_TRACKXYZ 0 7 0 1 2 3 1 0 0 1 0 1\nEDGE_SE3_TRACKXYZ 1 7 0 1 2 3 1 0 0 1 0 1\n" +
    "EDGE_SE3_PRIOR 0 0 " + kPose + kUnitInformation + "\nFIX 7 0\nEDGE_SE3:QUAT 0 1 " + kPose +
    kUnitInformation + "\n";

TEST_F(G2o, ParametersPriorsAndLandmarksAreSkippedWithANoteForEachKind) {
  std::vector<std::string> notes;
  const PoseGraph graph = read_g2o(folder_.write("graph.g2o", kForeign), notes);
  EXPECT_EQ(graph.nodes().size(), 2);
  EXPECT_EQ(graph.edges().size(), 1);
  EXPECT_TRUE(graph.nodes()[0].fixed);
  EXPECT_THAT(
      notes,
      testing::ElementsAre(
          "graph.g2o: 1 line PARAMS_SE3OFFSET skipped, from line 1 on: parameters are not read",
          "graph.g2o: 1 line VERTEX_TRACKXYZ skipped, from line 4 on: landmarks are not read",
          "graph.g2o: 2 lines EDGE_SE3_TRACKXYZ skipped, from line 5 on: landmarks are not read",
          "graph.g2o: 1 line EDGE_SE3_PRIOR skipped, from line 7 on: priors are not read"));
  notes.clear();
  EXPECT_THROW(
      static_cast<void>(read_g2o(folder_.path() / "graph.g2o", notes, ForeignEntries::kRefuse)),
      InputError);
  EXPECT_EQ(error_of(kForeign),
            "graph.g2o:1: PARAMS_SE3OFFSET: parameters are not read; remove "
            "the line");
}

TEST_F(G2o, InformationThatIsNegativeByRoundingIsRaisedToZeroWithANote) {
  // One of the six eigenvalues is -1e-12 of the largest.
  const std::string text = kVertices + "EDGE_SE3:QUAT 0 1 " + kPose +
                           " 100 0 0 0 0 0 1 0 0 0 0 -1e-10 0 0 0 1 0 0 1 0 1\n";
  std::vector<std::string> notes;
  const PoseGraph graph = read_g2o(folder_.write("graph.g2o", text), notes);
  EXPECT_NEAR(graph.edges()[0].information(2, 2), 0, 1e-15);
  EXPECT_NEAR(graph.edges()[0].information(0, 0), 100, 1e-12);
  EXPECT_THAT(notes, testing::ElementsAre(
                         "graph.g2o: 1 information matrix is negative by rounding, the first in "
                         "line 3: eigenvalues between -5e-6 of the largest and 0 are taken as 0"));
}

TEST_F(G2o, InformationOfLowRankStaysAsItIs) {
  const std::string text =
      kVertices + "EDGE_SE3:QUAT 0 1 " + kPose + " 100 0 0 0 0 0 1 1 0 0 0 1 0 0 0 0 0 0 0 0 3\n";
  std::vector<std::string> notes;
  const PoseGraph graph = read_g2o(folder_.write("graph.g2o", text), notes);
  EXPECT_TRUE(notes.empty());
  EXPECT_EQ(graph.edges()[0].information(1, 2), 1);
  EXPECT_EQ(graph.edges()[0].information(5, 5), 3);
}

TEST_F(G2o, AMissingFileIsAnError) {
  EXPECT_THROW(static_cast<void>(read_g2o(folder_.path() / "none.g2o")), InputError);
}

TEST(G2oData, ReadsThePublishedGraphs) {
  CVO_SLAM_REQUIRE_DATA("pose_graphs");
  const auto graph = read_g2o(test_data() / "pose_graphs" / "sphere2500.g2o");
  EXPECT_EQ(graph.nodes().size(), 2500);
  EXPECT_EQ(graph.edges().size(), 4949);
}

}  // namespace
}  // namespace cvo_slam
