// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Measures what false loops do to a pose graph under each loss. Prints the tables of
// docs/results/pose-graphs.md.
//   false_loops                          a generated graph, compared with its true poses
//   false_loops graph.g2o                a file, compared with its optimum without false loops
//   false_loops folder groundtruth.txt   a run: the ATE of its keyframes
#include <cstdio>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cvo_slam/backend/optimizer.h"
#include "cvo_slam/bench/graph_samples.h"
#include "cvo_slam/bench/report_errors.h"
#include "cvo_slam/core/association.h"
#include "cvo_slam/core/trajectory_errors.h"
#include "cvo_slam/io/g2o.h"
#include "cvo_slam/io/trajectory_files.h"

namespace cvo_slam {
namespace {

constexpr unsigned kSeed = 1;

/// Most iterations of a solve. Without a robust loss, false loops leave no minimum worth more.
constexpr int kMostIterations = 20;

struct Case {
  PoseGraph graph;                                // without false loops
  std::function<double(const PoseGraph&)> error;  // [m]
};

Case compared_with(PoseGraph graph, std::vector<SE3> reference) {
  return {std::move(graph), [reference = std::move(reference)](const PoseGraph& estimate) {
            return position_rmse(estimate, reference);
          }};
}

Case generated() {
  SampleGraph sample = make_rounds(100, kSeed);
  return compared_with(std::move(sample.graph), std::move(sample.truth));
}

Case published(const std::filesystem::path& file) {
  PoseGraph graph = read_g2o(file);
  PoseGraph optimum = graph;
  optimize(optimum);
  return compared_with(std::move(graph), poses_of(optimum));
}

/// The graph of a run. Its nodes are the lines of keyframes.txt, in the same order.
Case of_run(const std::filesystem::path& folder, const std::filesystem::path& ground_truth) {
  const auto error = [keyframes = read_tum(folder / "keyframes.txt"),
                      truth = read_tum(ground_truth)](const PoseGraph& graph) {
    std::vector<StampedPose> estimate = keyframes;
    for (std::size_t i = 0; i < estimate.size(); ++i) {
      estimate[i].T_world_camera = graph.nodes()[i].T_world_node;
    }
    return absolute_trajectory_error(associate(truth, estimate)).statistics.translation.rmse;
  };
  return {read_g2o(folder / "graph.g2o"), error};
}

Case make_case(const std::vector<std::string>& arguments) {
  if (arguments.empty()) return generated();
  return arguments.size() == 1 ? published(arguments[0]) : of_run(arguments[0], arguments[1]);
}

void print_row(const Case& given, double share, const char* name, RobustLoss loss) {
  PoseGraph graph = given.graph;
  add_false_loops(graph, share, kSeed);
  const Summary summary = optimize(graph, {.loss = loss, .max_iterations = kMostIterations});
  const std::size_t genuine = given.graph.edges().size();
  std::size_t lost = 0;
  for (std::size_t i = 0; i < genuine; ++i) lost += summary.weights[i] < 0.5 ? 1 : 0;
  fmt::print("| {:.0f} % ({}) | {} | {:.4f} | {} of {} | {} | {} | {:.2f} |\n", 100 * share,
             graph.edges().size() - genuine, name, given.error(graph),
             summary.rejected_edges() - lost, graph.edges().size() - genuine, lost,
             summary.iterations, summary.seconds);
  std::fflush(stdout);
}

void run(const std::vector<std::string>& arguments) {
  const Case given = make_case(arguments);
  fmt::print("| false loops | loss | error [m] | found | genuine rejected | iterations | s |\n");
  fmt::print("|---|---|---|---|---|---|---|\n");
  for (const double share : {0.0, 0.1, 0.2, 0.4}) {
    print_row(given, share, "none", RobustLoss::kNone);
    print_row(given, share, "huber", RobustLoss::kHuber);
    print_row(given, share, "cauchy", RobustLoss::kCauchy);
    print_row(given, share, "gnc", RobustLoss::kGnc);
  }
}

}  // namespace
}  // namespace cvo_slam

int main(int argc, char** argv) {
  return cvo_slam::report_errors([&] { cvo_slam::run({argv + 1, argv + argc}); });
}
