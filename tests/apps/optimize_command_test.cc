// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <csignal>
#include <cstdlib>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>

#include "cvo_slam/bench/graph_samples.h"
#include "cvo_slam/core/pose_graph.h"
#include "cvo_slam/io/g2o.h"
#include "cvo_slam/tests/apps/run_program.h"
#include "cvo_slam/tests/temporary_folder.h"
#include "cvo_slam/tests/test_data.h"

namespace cvo_slam {
namespace {

using testing::HasSubstr;

class OptimizeCommand : public testing::Test {
 protected:
  OptimizeCommand() { write_g2o(input_, make_rounds(20, 1).graph); }

  [[nodiscard]] ProgramResult run(const std::vector<std::string>& options) const {
    std::vector<std::string> arguments = {"optimize", input_, output_};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_program(arguments);
  }

  [[nodiscard]] nlohmann::json json_of(std::vector<std::string> options) const {
    options.emplace_back("--json");
    const ProgramResult result = run(options);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return nlohmann::json::parse(result.output);
  }

  TemporaryFolder folder_;
  std::filesystem::path input_ = folder_.path() / "in.g2o";
  std::filesystem::path output_ = folder_.path() / "out.g2o";
};

TEST_F(OptimizeCommand, PrintsATableAndWritesTheGraph) {
  const ProgramResult result = run({});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.errors, "");
  for (const char* text : {"nodes       60 in 1 connected part\n", "edges       99\n", "before",
                           "after", "cost", "chi2", "iterations", "seconds", "reason"}) {
    EXPECT_THAT(result.output, HasSubstr(text));
  }
  EXPECT_LT(graph_cost(read_g2o(output_)), graph_cost(read_g2o(input_)));
}

TEST_F(OptimizeCommand, PrintsOneJsonObject) {
  const auto json = json_of({});
  EXPECT_EQ(json["nodes"], 60);
  EXPECT_EQ(json["edges"], 99);
  EXPECT_EQ(json["converged"], true);
  const PoseGraph before = read_g2o(input_);
  const PoseGraph after = read_g2o(output_);
  // Poses in files are rounded once.
  EXPECT_NEAR(json["cost"]["before"], graph_cost(before), 1e-9 * graph_cost(before));
  EXPECT_NEAR(json["cost"]["after"], graph_cost(after), 1e-9 * graph_cost(after));
  EXPECT_NEAR(json["chi2_g2o"]["after"], graph_chi2_g2o(after), 1e-9 * graph_chi2_g2o(after));
}

TEST_F(OptimizeCommand, EveryStartAndSolverFindsTheOptimum) {
  const double optimum = json_of({})["cost"]["after"];
  for (const std::vector<std::string>& options : {std::vector<std::string>{"--init", "file"},
                                                  {"--init", "chordal"},
                                                  {"--init", "identity"},
                                                  {"--solver", "eigen"}}) {
    EXPECT_NEAR(json_of(options)["cost"]["after"], optimum, 1e-6 * optimum);
  }
  EXPECT_EQ(json_of({"--init", "identity"})["started_chordal"], true);
}

TEST_F(OptimizeCommand, FindsFalseLoops) {
  PoseGraph graph = make_rounds(20, 1).graph;
  add_false_loops(graph, 0.2, 1);  // of 40 loops
  write_g2o(input_, graph);
  EXPECT_EQ(json_of({"--loss", "gnc", "--loss-scale", "6"})["rejected_edges"], 8);
}

/// Returns the graph with its odometry measured from the newer to the older node.
PoseGraph with_reversed_odometry(const PoseGraph& graph) {
  PoseGraph result;
  for (const PoseGraphNode& node : graph.nodes()) result.add_node(node);
  for (PoseGraphEdge edge : graph.edges()) {
    if (edge.kind == EdgeKind::kOdometry) {
      std::swap(edge.from, edge.to);
      edge.T_from_to = edge.T_from_to.inverse();  // its information is the same in any frame
    }
    result.add_edge(edge);
  }
  return result;
}

// Odometry that points back was thrown away as false loops: 5.6 m instead of 0.05.
TEST_F(OptimizeCommand, FindsFalseLoopsWhereOdometryPointsBack) {
  const SampleGraph sample = make_rounds(20, 1);
  PoseGraph graph = sample.graph;
  add_false_loops(graph, 0.2, 1);  // of 40 loops
  write_g2o(input_, with_reversed_odometry(graph));
  const auto json = json_of({"--loss", "gnc", "--loss-scale", "6"});
  EXPECT_EQ(json["rejected_edges"], 8);
  EXPECT_TRUE(json["notes"].empty());
  // Odometry of 1 cm and 0.01 rad a step that loops hold together after 20 steps.
  EXPECT_LT(position_rmse(read_g2o(output_), sample.truth), 0.2);
}

TEST_F(OptimizeCommand, SaysWhenAllLoopsWereRejected) {
  PoseGraph graph = make_rounds(20, 1).graph;
  while (graph.edges().back().kind == EdgeKind::kLoop) graph.remove_edge(graph.edges().size() - 1);
  graph.add_edge({0, 30, SE3(Matrix3::Identity(), {30, 0, 0}), 1e4 * Matrix6::Identity()});
  write_g2o(input_, graph);
  const auto json = json_of({"--loss", "gnc"});
  ASSERT_EQ(json["notes"].size(), 1);
  EXPECT_THAT(json["notes"][0], HasSubstr("all that closes a loop was rejected, 1 edge"));
  EXPECT_THAT(run({"--loss", "gnc"}).output, HasSubstr("\nnote        all that closes a loop"));
}

TEST_F(OptimizeCommand, SkipsPriorsWithANoteUnlessItIsStrict) {
  std::string text = read_text(input_);
  text += "EDGE_SE3_PRIOR 0 0 1 2 3 0 0 0 1 1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 1 0 0 1 0 1\n";
  folder_.write("in.g2o", text);
  const std::string note = "in.g2o: 1 line EDGE_SE3_PRIOR skipped, from line 160 on";
  EXPECT_THAT(run({}).output, HasSubstr("\nnote        " + note));
  EXPECT_THAT(json_of({})["notes"][0], HasSubstr(note));
  std::filesystem::remove(output_);
  const ProgramResult strict = run({"--strict"});
  EXPECT_EQ(strict.exit_code, 2);
  EXPECT_THAT(strict.errors, HasSubstr("in.g2o:160: EDGE_SE3_PRIOR: priors are not read"));
  EXPECT_FALSE(std::filesystem::exists(output_));
}

/// While it lives, files cannot grow beyond a size, as on a disk that is full. Programs that are
/// started inherit the limit.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    // Writing then fails; without this, it would end the program.
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int) = SIG_DFL;
};

TEST_F(OptimizeCommand, AFullDiskLeavesTheGraphThatWasToBeReplaced) {
  output_ = input_;
  const std::string before = read_text(input_);
  constexpr rlim_t kLimit = 8192;  // enough for what the program prints
  ASSERT_GT(before.size(), kLimit);
  ProgramResult result;
  {
    const FileSizeLimit limit(kLimit);
    result = run({});
  }
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.errors, HasSubstr("in.g2o: cannot be written: "));
  EXPECT_THAT(result.errors, HasSubstr("check permissions and free space"));
  EXPECT_EQ(read_text(input_), before);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_.path()), {}), 1)
      << "nothing is left aside";
}

TEST_F(OptimizeCommand, SaysWhenItDidNotConverge) {
  const ProgramResult result = run({"--init", "file", "--max-iterations", "1"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.output, HasSubstr("NOT CONVERGED"));
}

TEST_F(OptimizeCommand, BadInputIsNamed) {
  folder_.write("in.g2o", "VERTEX_SE2 0 0 0 0\n");
  const ProgramResult result = run({});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.errors, HasSubstr("in.g2o:1: VERTEX_SE2: a planar graph"));
  EXPECT_FALSE(std::filesystem::exists(output_));
  EXPECT_EQ(run({"--max-iterations", "0"}).exit_code, 2);
  EXPECT_EQ(run({"--loss", "fair"}).exit_code, 2);
}

class OptimizeCommandOnData : public OptimizeCommand {};

/// CHOLMOD calls the installed BLAS, whose threads must not change a byte.
TEST_F(OptimizeCommandOnData, ThreadsDoNotChangeAByte) {
  CVO_SLAM_REQUIRE_DATA("pose_graphs");
  input_ = test_data() / "pose_graphs" / "sphere2500.g2o";
  const auto bytes_with = [&](const char* threads) {
    setenv("OPENBLAS_NUM_THREADS", threads, 1);
    setenv("OMP_NUM_THREADS", threads, 1);
    EXPECT_EQ(run({}).exit_code, 0);
    return read_text(output_);
  };
  EXPECT_EQ(bytes_with("1"), bytes_with("8"));
}

}  // namespace
}  // namespace cvo_slam
