// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cvo_slam/apps/command_line.h"
#include "cvo_slam/backend/optimizer.h"
#include "cvo_slam/core/pose_graph.h"
#include "cvo_slam/io/g2o.h"

namespace cvo_slam {
namespace {

enum class InitialPoses { kAuto, kFile, kChordal, kIdentity };

struct OptimizeArguments {
  std::filesystem::path input;
  std::filesystem::path output;
  OptimizerOptions options;
  InitialPoses initial = InitialPoses::kAuto;
  bool strict = false;
  bool json = false;
};

/// The cost of a graph in the conventions of Ceres and of g2o.
struct GraphCosts {
  double ceres = 0;
  double g2o = 0;
};

struct OptimizeReport {
  std::size_t nodes = 0;
  std::size_t edges = 0;
  std::size_t parts = 0;
  GraphCosts before;
  GraphCosts after;
  Summary summary;
  std::vector<std::string> notes;  ///< on the file, then on the optimisation
};

GraphCosts costs_of(const PoseGraph& graph) { return {graph_cost(graph), graph_chi2_g2o(graph)}; }

std::size_t count_parts(const PoseGraph& graph) {
  const std::vector<std::size_t> components = graph.components();
  return *std::max_element(components.begin(), components.end()) + 1;
}

/// Sets the option for the initial poses; kIdentity also resets every pose that is not fixed.
void choose_initial_poses(InitialPoses initial, PoseGraph& graph, OptimizerOptions& options) {
  switch (initial) {
    case InitialPoses::kAuto:
      options.initialization = Initialization::kAuto;
      break;
    case InitialPoses::kFile:
      options.initialization = Initialization::kGiven;
      break;
    case InitialPoses::kChordal:
      options.initialization = Initialization::kChordal;
      break;
    case InitialPoses::kIdentity:
      options.initialization = Initialization::kAuto;
      for (std::size_t i = 0; i < graph.nodes().size(); ++i) {
        if (!graph.nodes()[i].fixed) graph.set_pose(i, SE3());
      }
      break;
  }
}

std::string to_table(const OptimizeReport& report) {
  const Summary& summary = report.summary;
  std::string text =
      fmt::format("nodes       {} in {} connected part{}\nedges       {}", report.nodes,
                  report.parts, report.parts == 1 ? "" : "s", report.edges);
  if (summary.rejected_edges() > 0) text += fmt::format(", {} rejected", summary.rejected_edges());
  text += fmt::format("\n{:<12}{:>18}{:>18}\n", "", "before", "after");
  text += fmt::format("{:<12}{:>18.8g}{:>18.8g}   half the sum, residual [dp; 2 vec(dq)]\n", "cost",
                      report.before.ceres, report.after.ceres);
  text += fmt::format("{:<12}{:>18.8g}{:>18.8g}   g2o's sum, residual [dp; vec(dq)]\n", "chi2",
                      report.before.g2o, report.after.g2o);
  text += fmt::format("start       {}\n", summary.started_chordal ? "chordal" : "given poses");
  text += fmt::format("iterations  {} in {} solve{}\n", summary.iterations, summary.solves,
                      summary.solves == 1 ? "" : "s");
  text += fmt::format("seconds     {:.3f}\n", summary.seconds);
  text +=
      fmt::format("reason      {}{}\n", summary.converged ? "" : "NOT CONVERGED: ", summary.reason);
  for (const std::string& note : report.notes) text += fmt::format("note        {}\n", note);
  return text;
}

nlohmann::ordered_json to_json(const OptimizeReport& report) {
  const Summary& summary = report.summary;
  return {{"nodes", report.nodes},
          {"edges", report.edges},
          {"connected_parts", report.parts},
          {"rejected_edges", summary.rejected_edges()},
          {"cost", {{"before", report.before.ceres}, {"after", report.after.ceres}}},
          {"chi2_g2o", {{"before", report.before.g2o}, {"after", report.after.g2o}}},
          {"started_chordal", summary.started_chordal},
          {"iterations", summary.iterations},
          {"solves", summary.solves},
          {"seconds", summary.seconds},
          {"converged", summary.converged},
          {"reason", summary.reason},
          {"notes", report.notes}};
}

int run_optimize(const OptimizeArguments& arguments) {
  std::vector<std::string> notes;
  PoseGraph graph = read_g2o(arguments.input, notes,
                             arguments.strict ? ForeignEntries::kRefuse : ForeignEntries::kSkip);
  OptimizerOptions options = arguments.options;
  choose_initial_poses(arguments.initial, graph, options);
  OptimizeReport report{graph.nodes().size(), graph.edges().size(), count_parts(graph), {}, {}, {},
                        std::move(notes)};
  report.before = costs_of(graph);
  report.summary = optimize(graph, options);
  const std::vector<std::string>& more = report.summary.notes;
  report.notes.insert(report.notes.end(), more.begin(), more.end());
  report.after = costs_of(graph);
  write_g2o(arguments.output, graph);
  fmt::print("{}", arguments.json ? to_json(report).dump(2) + "\n" : to_table(report));
  return report.summary.converged ? kDone : kFailed;
}

void add_optimize_options(Command& command, OptimizeArguments& arguments) {
  OptimizerOptions& options = arguments.options;
  command.add("in", &arguments.input, "A pose graph in g2o format (SE3:QUAT)").required();
  command.add("out", &arguments.output, "File for the optimised graph").required();
  command.add_choice<InitialPoses, InitialPoses>(
      "--init", &arguments.initial,
      {{"auto", InitialPoses::kAuto},
       {"file", InitialPoses::kFile},
       {"chordal", InitialPoses::kChordal},
       {"identity", InitialPoses::kIdentity}},
      "auto, file, chordal or identity: the poses that the search starts from. auto = those of the "
      "file or the chordal ones, whichever cost less; identity = auto with all poses set to the "
      "identity first (default auto)");
  command.add_choice<RobustLoss, RobustLoss>(
      "--loss", &options.loss,
      {{"none", RobustLoss::kNone},
       {"huber", RobustLoss::kHuber},
       {"cauchy", RobustLoss::kCauchy},
       {"gnc", RobustLoss::kGnc}},
      "none, huber, cauchy or gnc: the robust loss of edges that do not join consecutive vertices; "
      "gnc also finds the wrong ones among them, and leaves connected what was connected (default "
      "none)");
  command.add("--loss-scale", &options.loss_scale,
              "Standard deviations above which an edge is robustified (default 4.1)");
  command.add_choice<LinearSolver, LinearSolver>(
      "--solver", &options.solver,
      {{"suitesparse", LinearSolver::kSuiteSparse}, {"eigen", LinearSolver::kEigen}},
      "suitesparse or eigen: the sparse Cholesky factorisation (default suitesparse)");
  command.add("--max-iterations", &options.max_iterations,
              "Largest number of iterations of a solve (default 100)");
  command.add("--strict", &arguments.strict,
              "Refuse a file with priors, landmarks or parameters instead of skipping them with a "
              "note");
  command.add("--json", &arguments.json, "Print one JSON object instead of a table");
}

}  // namespace

void add_optimize_command(CLI::App& app, Action& action) {
  const auto arguments = std::make_shared<OptimizeArguments>();
  Command command(app, "optimize", "Optimise a pose graph with the back-end alone");
  add_optimize_options(command, *arguments);
  command.on_parsed(action, [arguments] { return run_optimize(*arguments); });
}

}  // namespace cvo_slam
