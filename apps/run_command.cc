// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <ctime>
#include <exception>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <system_error>
#include <utility>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "cvo_slam/apps/command.h"
#include "cvo_slam/apps/interrupt.h"
#include "cvo_slam/apps/loop_pictures.h"
#include "cvo_slam/apps/odometry_run.h"
#include "cvo_slam/apps/run_files.h"
#include "cvo_slam/apps/run_report.h"
#include "cvo_slam/apps/slam_run.h"
#include "cvo_slam/apps/tracking_arguments.h"
#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/io/options_file.h"
#include "cvo_slam/io/trajectory_files.h"
#include "cvo_slam/loop/vocabulary_files.h"

namespace cvo_slam {
namespace {

struct RunArguments {
  TrackingArguments tracking;
  std::string mode = "slam";
  std::filesystem::path vocabulary;  // empty = the built-in one
  std::filesystem::path out;
  double max_lost = 0.05;
  bool quiet = false;
  bool json = false;
  bool dump_config = false;
  bool no_map = false;
  LoopPictures loop_pictures = LoopPictures::kAccepted;
};

/// Makes a folder that was not there: `name` in `parent`, or `name`_2, `name`_3, ...
std::filesystem::path make_new_folder(const std::filesystem::path& parent,
                                      const std::string& name) {
  auto folder = parent / name;
  for (int i = 2; !make_folder(folder); ++i) folder = parent / fmt::format("{}_{}", name, i);
  return folder;
}

/// results/<sequence>/<time>, with a link `latest` beside it where a link can be made.
std::filesystem::path default_folder(const std::string& sequence) {
  const auto parent = std::filesystem::path("results") / sequence;
  const auto time = fmt::format("{:%Y-%m-%d_%H-%M-%S}", fmt::localtime(std::time(nullptr)));
  auto folder = make_new_folder(parent, time);
  const auto link = parent / "latest";
  std::error_code ignored;
  // Where a user put a file of that name, it stays.
  if (std::filesystem::is_symlink(link, ignored)) std::filesystem::remove(link, ignored);
  std::filesystem::create_directory_symlink(folder.filename(), link, ignored);
  return folder;
}

/// Makes the folder, without files of an earlier run, and proves that it can be written to before
/// hours of work go into it.
void prepare_folder(const std::filesystem::path& folder) {
  make_folder(folder);
  remove_run(folder);
  write_tum(folder / "trajectory.txt", {});
}

void print_result(const RunArguments& arguments, const RunReport& report,
                  const std::filesystem::path& folder) {
  if (arguments.json) {
    fmt::print("{}\n", to_json(report).dump(2));
  } else if (!arguments.quiet) {
    fmt::print("{}{:<12} {}\n", to_table(report), "files", folder.string());
  }
}

/// Writes the files and prints the figures, these even where a file cannot be written.
void deliver(const RunArguments& arguments, RunReport& report,
             const std::filesystem::path& folder) {
  std::exception_ptr failure;
  try {
    write_run(folder, report);
  } catch (...) {
    failure = std::current_exception();
  }
  print_result(arguments, report, folder);
  if (failure) std::rethrow_exception(failure);
}

/// Null = the built-in one.
std::shared_ptr<const Vocabulary> vocabulary_of(const RunArguments& arguments) {
  if (arguments.vocabulary.empty()) return nullptr;
  if (arguments.mode != "slam") {
    throw OptionError(fmt::format("--vocabulary is for --mode slam, not {}", arguments.mode));
  }
  return std::make_shared<const Vocabulary>(read_vocabulary(arguments.vocabulary));
}

int run(const RunArguments& arguments) {
  ProgramOptions options = arguments.tracking.options();
  options.slam.loops.enabled = arguments.mode == "slam";
  if (arguments.dump_config) {
    fmt::print("{}", options_to_yaml(describe(options), true));
    return kDone;
  }
  const InterruptGuard interrupt;
  const auto vocabulary = vocabulary_of(arguments);
  const auto data = arguments.tracking.open();
  const FrameRange range = arguments.tracking.range(data->size());
  const auto folder = arguments.out.empty() ? default_folder(data->name()) : arguments.out;
  prepare_folder(folder);

  RunReport report{*data, range,        options,       arguments.mode,         {}, std::nullopt, {},
                   {},    std::nullopt, data->notes(), arguments.loop_pictures};
  const RunControl control{arguments.quiet, arguments.no_map ? 0 : options.map.pixel_step};
  if (arguments.mode != "odometry") {
    SlamRun slam = run_slam(*data, range, options, vocabulary, control);
    report.run = std::move(slam.run);
    report.trajectory = std::move(slam.trajectory);
    report.graph = std::move(slam.graph);
  } else {
    report.run = run_odometry(*data, range, options.tracker, control);
    report.trajectory = to_trajectory(report.run.records);
  }
  report.map = make_run_map(report.run, report.graph, report.trajectory, data->camera(),
                            options.map, options.tracker.threads);
  report.evaluation = evaluate_run(*data, report.trajectory, report.notes);
  deliver(arguments, report, folder);
  if (report.run.interrupted) return kInterrupted;
  return report.lost_share() > arguments.max_lost ? kTrackingLost : kDone;
}

}  // namespace

void add_run_command(CLI::App& app, Action& action) {
  const auto arguments = std::make_shared<RunArguments>();
  auto* command =
      app.add_subcommand("run", "Track a sequence; write trajectory, map, plots and a report");
  arguments->tracking.add_to(*command);
  command
      ->add_option("--mode", arguments->mode,
                   "odometry = the tracker alone; graph = with a graph of keyframes; slam = and "
                   "with places that are recognised")
      ->check(CLI::IsMember({"odometry", "graph", "slam"}))
      ->capture_default_str();
  command->add_option(
      "--vocabulary", arguments->vocabulary,
      "Vocabulary file for --mode slam, ours or ORB-SLAM's text (default: built in)");
  command->add_option("--out", arguments->out,
                      "Folder for the files (default results/<sequence>/<time>, linked as latest)");
  command
      ->add_option("--max-lost", arguments->max_lost,
                   "Share of lost frames above which the exit code is 3")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  command->add_flag("--dump-config", arguments->dump_config,
                    "Print the effective options as YAML with their documentation, and end");
  command->add_flag("--no-map", arguments->no_map,
                    "Neither map.ply nor map.png: saves their memory and time");
  const std::map<std::string, LoopPictures> loop_pictures = {{"none", LoopPictures::kNone},
                                                             {"accepted", LoopPictures::kAccepted},
                                                             {"all", LoopPictures::kAll}};
  command
      ->add_option("--loop-pictures", arguments->loop_pictures,
                   "none, accepted or all: the recognised places whose images are drawn into the "
                   "folder loops (default accepted)")
      ->transform(CLI::CheckedTransformer(loop_pictures).description(""));
  command->add_flag("--quiet", arguments->quiet, "No progress, no table");
  command->add_flag("--json", arguments->json, "Print the report as JSON in place of the table");
  command->callback([&action, arguments] { action = [arguments] { return run(*arguments); }; });
}

}  // namespace cvo_slam
