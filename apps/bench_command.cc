// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <opencv2/core/utility.hpp>

#include "cvo_slam/apps/benchmark_report.h"
#include "cvo_slam/apps/command_line.h"
#include "cvo_slam/apps/depth_clock.h"
#include "cvo_slam/apps/odometry_benchmark.h"
#include "cvo_slam/apps/progress.h"
#include "cvo_slam/apps/report_json.h"
#include "cvo_slam/apps/tracking_arguments.h"
#include "cvo_slam/apps/variants.h"
#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/io/trajectory_files.h"

namespace cvo_slam {
namespace {

struct BenchArguments {
  TrackingArguments tracking;
  std::vector<std::string> systems = odometry_system_names();
  std::vector<std::string> variants = variant_names();
  std::string mode = "slam";
  std::filesystem::path out;
  std::filesystem::path plot;
  bool quiet = false;
  bool json = false;
};

ProgramOptions single_thread_options(const TrackingArguments& arguments) {
  ProgramOptions options = arguments.options();
  if (options.slam.tracker.threads != 1) {
    throw OptionError(
        fmt::format("tracker.threads={}: bench compares single threads; leave out "
                    "the option tracker.threads and --threads",
                    options.slam.tracker.threads));
  }
  options.slam.schedule = Schedule::kInline;  // the time of another thread would not be seen
  return options;
}

void write_trajectories(const std::filesystem::path& folder, const OdometryBenchmark& benchmark) {
  for (const auto& result : benchmark.results) {
    if (result.built_in) write_tum(folder / (result.name + ".txt"), {result.poses, {}});
  }
}

void check_reference(const Dataset& data) {
  if (!data.reference().empty()) return;
  throw OptionError(
      fmt::format("--plot: {} has no ground truth to draw errors from; leave it out, or "
                  "take a sequence that has one",
                  data.name()));
}

using MakeContestants =
    std::function<std::vector<Contestant>(const Camera&, const ProgramOptions&)>;

int run_benchmark(const BenchArguments& arguments, const MakeContestants& make) {
  const ProgramOptions options = single_thread_options(arguments.tracking);
  const auto timed = open_timed(arguments.tracking.sequence, options.slam.tracker);
  const auto& data = timed.data;
  const FrameRange frames = arguments.tracking.range(data->size());
  const auto contestants = make(data->camera(), options);
  if (!arguments.plot.empty()) check_reference(*data);
  // Made before the work, so that an unusable folder is reported at once.
  for (const auto& folder : {arguments.out, arguments.plot}) {
    if (!folder.empty()) make_folder(folder);
  }

  cv::setNumThreads(1);  // for the whole process, which is this program's own
  Progress progress(frames.size(), arguments.quiet);
  auto benchmark =
      run_odometry_benchmark(*data, frames, contestants,
                             [&](std::size_t done, std::size_t) { progress.update(done, ""); });
  benchmark.depth_offset = timed.clock.text();
  if (!arguments.out.empty()) write_trajectories(arguments.out, benchmark);
  if (!arguments.plot.empty()) write_benchmark_plots(arguments.plot, *data, benchmark);
  fmt::print("{}",
             arguments.json ? json_text(*data, benchmark) + "\n" : to_table(*data, benchmark));
  return kDone;
}

void add_output_arguments(Command& command, BenchArguments& arguments) {
  command.add("--out", &arguments.out, "Folder for the trajectories, <name>.txt in TUM format");
  command.add("--plot", &arguments.plot,
              "Folder for odometry.png and odometry.svg: distributions of the errors from frame to "
              "frame, and top views; needs ground truth");
  command.add("--quiet", &arguments.quiet, "Show no progress");
  command.add("--json", &arguments.json, "Print one JSON object instead of a table");
}

void add_odometry_command(Command& bench, Action& action) {
  const auto arguments = std::make_shared<BenchArguments>();
  Command command(bench, "odometry",
                  "Compare accuracy and CPU time with the odometries of OpenCV on the same frames");
  arguments->tracking.add_to(command);
  command
      .add("--systems", &arguments->systems,
           fmt::format("The systems to compare, separated by commas: {} (default: all)",
                       fmt::join(odometry_system_names(), ", ")))
      .separated_by_commas();
  add_output_arguments(command, *arguments);
  command.on_parsed(action, [arguments] {
    return run_benchmark(*arguments, [&](const Camera& camera, const ProgramOptions& options) {
      return make_contestants(arguments->systems, camera, options.slam.tracker);
    });
  });
}

void add_variants_command(Command& bench, Action& action) {
  const auto arguments = std::make_shared<BenchArguments>();
  Command command(bench, "variants",
                  "Run ours with options that differ a little: what of a result is luck");
  arguments->tracking.add_to(command);
  command.add("--mode", &arguments->mode, "As for run: odometry, graph or slam")
      .one_of({"odometry", "graph", "slam"})
      .show_default();
  command
      .add("--variants", &arguments->variants,
           fmt::format("The variants to run, separated by commas: {} (default: all)",
                       fmt::join(variant_names(), ", ")))
      .separated_by_commas();
  add_output_arguments(command, *arguments);
  command.on_parsed(action, [arguments] {
    return run_benchmark(*arguments, [&](const Camera& camera, const ProgramOptions& options) {
      return make_variants(arguments->variants, arguments->mode, camera, options);
    });
  });
}

}  // namespace

void add_bench_command(CLI::App& app, Action& action) {
  Command bench(app, "bench", "Compare with other systems, and measure what of a result is luck");
  bench.require_subcommand();
  add_odometry_command(bench, action);
  add_variants_command(bench, action);
}

}  // namespace cvo_slam
