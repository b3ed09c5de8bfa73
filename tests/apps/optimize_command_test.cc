// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

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
