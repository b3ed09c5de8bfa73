// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "cvo_slam/apps/argument_text.h"
#include "cvo_slam/apps/command_line.h"
#include "cvo_slam/apps/evaluation_plots.h"
#include "cvo_slam/apps/evaluation_report.h"
#include "cvo_slam/apps/report_json.h"
#include "cvo_slam/core/error.h"
#include "cvo_slam/core/numbers.h"
#include "cvo_slam/io/trajectory_files.h"

namespace cvo_slam {
namespace {

enum class Metric { kEvo, kTum, kPaper };

struct EvalArguments {
  std::filesystem::path reference;
  std::filesystem::path estimate;
  EvaluationOptions options;
  std::optional<Metric> metric;
  std::optional<double> delta;
  std::optional<DeltaUnit> unit;
  bool all_pairs = false;
  std::string time_offset = "0";
  std::filesystem::path plot_folder;
  bool json = false;
};

/// Returns the relative errors that the command line asks for; each metric has its own defaults.
std::vector<RelativePoseOptions> relative_options(const EvalArguments& arguments) {
  const bool has_delta = arguments.delta || arguments.unit || arguments.all_pairs;
  if (!arguments.metric && !has_delta) return EvaluationOptions().relative;
  switch (arguments.metric.value_or(Metric::kEvo)) {
    case Metric::kPaper:
      if (has_delta) {
        throw OptionError(
            "--metric paper is frame to frame: leave out --delta, --unit and --all-pairs");
      }
      return {cvo_paper_options()};
    case Metric::kTum:
      if (arguments.unit.value_or(DeltaUnit::kSeconds) != DeltaUnit::kSeconds) {
        throw OptionError("--metric tum is over seconds: leave out --unit or use --metric evo");
      }
      return {{.delta = arguments.delta.value_or(1)}};
    case Metric::kEvo:
      break;
  }
  return {{.delta = arguments.delta.value_or(1),
           .unit = arguments.unit.value_or(DeltaUnit::kFrames),
           .all_pairs = arguments.all_pairs}};
}

constexpr const char* kAuto = "auto";

/// Returns the offset that the command line gives; 0 for auto.
double given_time_offset(const EvalArguments& arguments) {
  if (arguments.time_offset == kAuto) return 0;
  const auto seconds = parse_finite(arguments.time_offset);
  if (seconds) return *seconds;
  throw OptionError(
      fmt::format("--time-offset '{}': expected seconds or auto", arguments.time_offset));
}

/// Throws InputError if the file has no pose; otherwise it would be said of the estimate's file.
ForeignTrajectory read_poses(const std::filesystem::path& file) {
  ForeignTrajectory trajectory = read_foreign_tum(file);
  if (!trajectory.poses.empty()) return trajectory;
  const std::size_t invalid = trajectory.left_out.invalid;
  throw InputError(file, fmt::format("has no pose{}; expected lines 'stamp tx ty tz qx qy qz qw'",
                                     invalid > 0 ? " with finite numbers" : ""));
}

/// Adds the figures with the offset at which the rotations agree best; they stand beside those
/// without it.
void add_at_best_offset(const ForeignTrajectory& reference, const ForeignTrajectory& estimate,
                        EvaluationReport& report) {
  const auto offset =
      measure_time_offset(reference.poses, estimate.poses, report.options.association);
  if (!offset) {
    report.notes.emplace_back(
        "the clocks of the two were not compared: no offset of at most half a second has the "
        "smallest rotation error over a second");
    return;
  }
  EvaluationOptions options = report.options;
  options.association.time_offset = *offset;
  try {
    report.at_best_offset = std::make_shared<EvaluationReport>(
        evaluate(reference.poses, estimate.poses, options, report.left_out));
  } catch (const DataError& error) {
    report.notes.push_back(
        fmt::format("no figures with the measured offset of {} s: {}", *offset, error.what()));
  }
}

int run_eval(const EvalArguments& arguments) {
  EvaluationOptions options = arguments.options;
  options.relative = relative_options(arguments);
  options.association.time_offset = given_time_offset(arguments);
  const auto reference = read_poses(arguments.reference);
  const auto estimate = read_poses(arguments.estimate);
  EvaluationReport report;
  try {
    report = evaluate(reference.poses, estimate.poses, options,
                      {.reference = reference.left_out, .estimate = estimate.left_out});
  } catch (const DataError& error) {
    throw InputError(arguments.estimate, error.what());
  }
  if (arguments.time_offset == kAuto) add_at_best_offset(reference, estimate, report);
  if (reference.sorted) report.notes.emplace_back("reference: stamps out of order; sorted");
  if (estimate.sorted) report.notes.emplace_back("estimate: stamps out of order; sorted");
  if (!arguments.plot_folder.empty()) {
    write_figures(arguments.plot_folder,
                  evaluation_figures(reference.poses, estimate.poses, report));
  }
  fmt::print("{}", arguments.json ? json_text(report) + "\n" : to_table(report));
  return kDone;
}

void add_eval_options(Command& command, EvalArguments& arguments) {
  auto& association = arguments.options.association;
  command.add("reference", &arguments.reference, "The true trajectory, a file in TUM format")
      .required();
  command.add("estimate", &arguments.estimate, "The trajectory to judge, a file in TUM format")
      .required();
  command.add_choice<Alignment, Alignment>(
      "--align", &arguments.options.alignment,
      {{"none", Alignment::kNone}, {"se3", Alignment::kSe3}, {"sim3", Alignment::kSim3}},
      "none, se3 or sim3: how the estimate is fitted to the reference first (default se3)");
  command.add_choice<std::optional<Metric>, Metric>(
      "--metric", &arguments.metric,
      {{"evo", Metric::kEvo}, {"tum", Metric::kTum}, {"paper", Metric::kPaper}},
      "evo, tum or paper: the relative error; tum = all pairs --delta seconds apart, paper = the "
      "one of the CVO paper, from frame to frame (default: tum, and evo from frame to frame)");
  command.add("--delta", &arguments.delta, "Distance between the two poses of a pair (default 1)");
  command.add_choice<std::optional<DeltaUnit>, DeltaUnit>(
      "--unit", &arguments.unit,
      {{"frames", DeltaUnit::kFrames}, {"m", DeltaUnit::kMetres}, {"s", DeltaUnit::kSeconds}},
      "Unit of --delta: frames, m or s (default frames)");
  command.add("--all-pairs", &arguments.all_pairs,
              "Begin a pair at every pose, not only where the last pair ended");
  command.add("--max-diff", &association.max_difference,
              "Largest difference between the stamps of a match [s] (default 0.02)");
  command.add("--interpolate", &association.interpolate,
              "Interpolate the reference at the stamps of the estimate");
  command.add(
      "--time-offset", &arguments.time_offset,
      "Time to add to the stamps of the estimate [s]; auto = print the figures a second time, "
      "with the offset at which the rotations over a second agree best (default 0)");
  command.add("--plot", &arguments.plot_folder,
              "Folder for pictures of the trajectories and their errors (PNG and SVG)");
  command.add("--json", &arguments.json, "Print one JSON object instead of a table");
}

}  // namespace

void add_eval_command(CLI::App& app, Action& action) {
  const auto arguments = std::make_shared<EvalArguments>();
  Command command(app, "eval", "Compute the errors of a trajectory against a reference");
  add_eval_options(command, *arguments);
  command.on_parsed(action, [arguments] { return run_eval(*arguments); });
}

}  // namespace cvo_slam
