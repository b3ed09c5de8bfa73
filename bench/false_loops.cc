// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// false_loops [graph.g2o]: what false loops do to a graph under each loss, as the table of
// docs/backend.md. Without a file the graph is the one of the tests, whose true poses are known.
#include <cstdio>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cvo_slam/backend/optimizer.h"
#include "cvo_slam/bench/graph_samples.h"
#include "cvo_slam/io/g2o.h"

namespace cvo_slam {
namespace {

constexpr unsigned kSeed = 1;

/// Without a robust loss false loops leave no minimum worth waiting for.
constexpr int kMostIterations = 20;

struct Case {
  PoseGraph graph;             // without false loops
  std::vector<SE3> reference;  // the true poses or, of a file, the optimum without false loops
};

Case make_case(int argc, char** argv) {
  if (argc < 2) {
    SampleGraph sample = make_rounds(100, kSeed);
    return {std::move(sample.graph), std::move(sample.truth)};
  }
  PoseGraph graph = read_g2o(argv[1]);
  PoseGraph optimum = graph;
  optimize(optimum);
  return {std::move(graph), poses_of(optimum)};
}

void print_row(const Case& of, double share, const char* name, RobustLoss loss) {
  PoseGraph graph = of.graph;
  add_false_loops(graph, share, kSeed);
  const Summary summary = optimize(graph, {.loss = loss, .max_iterations = kMostIterations});
  const std::size_t genuine = of.graph.edges().size();
  std::size_t lost = 0;
  for (std::size_t i = 0; i < genuine; ++i) lost += summary.weights[i] < 0.5 ? 1 : 0;
  fmt::print("| {:.0f} % ({}) | {} | {:.4f} | {} of {} | {} | {} | {:.2f} |\n", 100 * share,
             graph.edges().size() - genuine, name, position_rmse(graph, of.reference),
             summary.rejected_edges() - lost, graph.edges().size() - genuine, lost,
             summary.iterations, summary.seconds);
  std::fflush(stdout);
}

int main(int argc, char** argv) {
  const Case of = make_case(argc, argv);
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
