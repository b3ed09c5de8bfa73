// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// false_loops [graph.g2o | folder of a run  groundtruth.txt]: what false loops do to a graph under
// each loss, as the tables of docs/results/pose-graphs.md. Without arguments the graph is the one
// of the tests, whose true poses are known; a file's is compared with its optimum without false
// loops, a run's (ATE of its keyframes) with the ground truth.
#include <cstdio>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cvo_slam/backend/optimizer.h"
#include "cvo_slam/bench/graph_samples.h"
#include "cvo_slam/core/absolute_trajectory_error.h"
#include "cvo_slam/core/association.h"
#include "cvo_slam/io/g2o.h"
#include "cvo_slam/io/tum_trajectory.h"

namespace cvo_slam {
namespace {

constexpr unsigned kSeed = 1;

/// Without a robust loss false loops leave no minimum worth waiting for.
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

Case made_up() {
  SampleGraph sample = make_rounds(100, kSeed);
  return compared_with(std::move(sample.graph), std::move(sample.truth));
}

Case published(const std::filesystem::path& file) {
  PoseGraph graph = read_g2o(file);
  PoseGraph optimum = graph;
  optimize(optimum);
  return compared_with(std::move(graph), poses_of(optimum));
}

/// The nodes of a run's graph are the lines of its keyframes.txt, in this order.
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
  if (arguments.empty()) return made_up();
  return arguments.size() == 1 ? published(arguments[0]) : of_run(arguments[0], arguments[1]);
}

void print_row(const Case& of, double share, const char* name, RobustLoss loss) {
  PoseGraph graph = of.graph;
  add_false_loops(graph, share, kSeed);
  const Summary summary = optimize(graph, {.loss = loss, .max_iterations = kMostIterations});
  const std::size_t genuine = of.graph.edges().size();
  std::size_t lost = 0;
  for (std::size_t i = 0; i < genuine; ++i) lost += summary.weights[i] < 0.5 ? 1 : 0;
  fmt::print("| {:.0f} % ({}) | {} | {:.4f} | {} of {} | {} | {} | {:.2f} |\n", 100 * share,
             graph.edges().size() - genuine, name, of.error(graph), summary.rejected_edges() - lost,
             graph.edges().size() - genuine, lost, summary.iterations, summary.seconds);
  std::fflush(stdout);
}

int main(int argc, char** argv) {
  const Case of = make_case({argv + 1, argv + argc});
  fmt::print("| false loops | loss | error [m] | found | genuine rejected | iterations | s |\n");
  fmt::print("|---|---|---|---|---|---|---|\n");
  for (const double share : {0.0, 0.1, 0.2, 0.4}) {
    print_row(of, share, "none", RobustLoss::kNone);
    print_row(of, share, "huber", RobustLoss::kHuber);
    print_row(of, share, "cauchy", RobustLoss::kCauchy);
    print_row(of, share, "gnc", RobustLoss::kGnc);
  }
  return 0;
}

}  // namespace
}  // namespace cvo_slam

int main(int argc, char** argv) { return cvo_slam::main(argc, argv); }
