// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <csignal>
#include <ctime>
#include <exception>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "cvo_slam/apps/command_line.h"
#include "cvo_slam/apps/depth_clock.h"
#include "cvo_slam/apps/loop_pictures.h"
#include "cvo_slam/apps/report_json.h"
#include "cvo_slam/apps/run_files.h"
#include "cvo_slam/apps/run_report.h"
#include "cvo_slam/apps/sequence_run.h"
#include "cvo_slam/apps/tracking_arguments.h"
#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/io/map_files.h"
#include "cvo_slam/io/options_file.h"
#include "cvo_slam/io/trajectory_files.h"
#include "cvo_slam/loop/vocabulary.h"

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
  bool overwrite = false;
  bool follow = false;
  std::optional<double> end_after;  // [s]
  std::filesystem::path load_map;   // empty = none
  bool localize = false;
  bool save_map = false;
  LoopPictures loop_pictures = LoopPictures::kAccepted;

  /// True if the number of frames is not known before the end.
  [[nodiscard]] bool is_open_ended() const { return follow || tracking.sequence.is_pipe(); }
};

/// Makes and returns a new folder: `name` in `parent` or, if that exists, `name`_2, `name`_3, ...
std::filesystem::path make_new_folder(const std::filesystem::path& parent,
                                      const std::string& name) {
  auto folder = parent / name;
  for (int i = 2; !make_folder(folder); ++i) folder = parent / fmt::format("{}_{}", name, i);
  return folder;
}

/// Makes and returns results/<sequence>/<time>, with a link `latest` beside it if the file system
/// has links.
std::filesystem::path default_folder(const std::string& sequence) {
  const auto parent = std::filesystem::path("results") / sequence;
  const auto time = fmt::format("{:%Y-%m-%d_%H-%M-%S}", fmt::localtime(std::time(nullptr)));
  auto folder = make_new_folder(parent, time);
  const auto link = parent / "latest";
  std::error_code ignored;
  // A file of that name that a user put there stays.
  if (std::filesystem::is_symlink(link, ignored)) std::filesystem::remove(link, ignored);
  std::filesystem::create_directory_symlink(folder.filename(), link, ignored);
  return folder;
}

void print_result(const RunArguments& arguments, const RunReport& report,
                  const std::filesystem::path& folder) {
  if (arguments.json) {
    fmt::print("{}\n", json_text(report));
  } else if (!arguments.quiet) {
    fmt::print("{}{:<12} {}\n", to_table(report), "files", folder.string());
  }
}

/// Writes the files and prints the figures; the figures even if a file cannot be written.
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

/// Returns the vocabulary that --vocabulary names; null means the built-in one.
std::shared_ptr<const Vocabulary> vocabulary_of(const RunArguments& arguments) {
  if (arguments.vocabulary.empty()) return nullptr;
  if (arguments.mode != "slam") {
    throw OptionError(fmt::format("--vocabulary is for --mode slam, not {}", arguments.mode));
  }
  return std::make_shared<const Vocabulary>(read_vocabulary(arguments.vocabulary));
}

/// Throws OptionError if arguments that have to do with maps do not fit one another.
void check_map_arguments(const RunArguments& arguments) {
  if (arguments.localize && arguments.load_map.empty()) {
    throw OptionError("--localize needs the map to locate the camera in: --load-map <folder>");
  }
  if (arguments.localize && arguments.save_map) {
    throw OptionError("--localize leaves the map as it is, so that there is none to save");
  }
  if (!arguments.load_map.empty() && arguments.mode != "slam") {
    throw OptionError(fmt::format("--load-map is for --mode slam, not {}", arguments.mode));
  }
  if (arguments.save_map && arguments.mode == "odometry") {
    throw OptionError("--save-map is for --mode slam or graph, not odometry");
  }
}

/// Reads the map that --load-map names, for the camera of the sequence.
std::optional<LoadedMap> loaded_map(const RunArguments& arguments, const Camera& camera,
                                    std::vector<std::string>& notes) {
  if (arguments.load_map.empty()) return std::nullopt;
  LoadedMap loaded{read_map(arguments.load_map, notes),
                   arguments.localize ? MapUse::kLocalize : MapUse::kExtend};
  if (!loaded.map.memory) {
    throw InputError(arguments.load_map,
                     "is a map for pictures only; make one with `cvo_slam run --save-map`, in the "
                     "folder map of the run");
  }
  Camera& made_with = loaded.map.memory->camera;
  if (!is_same_camera(made_with, camera)) {
    throw InputError(arguments.load_map,
                     fmt::format("was made with another camera, '{}'; the recording has '{}': "
                                 "compare camera.yaml there with `cvo_slam info`",
                                 made_with.name, camera.name));
  }
  made_with = camera;  // its depth offset is that of the recording
  return loaded;
}

/// Adds the points that this run saw, and those of the map that it went on from, to the map that it
/// saves.
void add_surface(RunReport& report, const std::optional<LoadedMap>& loaded) {
  std::vector<MapPoint>& points = report.saved_map->points;
  if (loaded) points = loaded->map.points;
  const auto& seen = report.map.map.points;
  points.insert(points.end(), seen.begin(), seen.end());
}

/// What a run reads.
struct RunInput {
  std::shared_ptr<const Dataset> data;  // null if the user interrupted before the first frame
  std::shared_ptr<FrameSource> frames;
  DepthClock clock;
  FrameRange range;  // empty if it is not known before the end
};

RunInput open_followed_input(const RunArguments& arguments) {
  if (!arguments.tracking.frames.empty()) {
    throw OptionError("--frames needs the number of frames, which --follow and a pipe do not know");
  }
  FollowOptions options;
  options.end_after = arguments.end_after.value_or(options.end_after);
  options.stop = &InterruptGuard::requested;
  if (!arguments.quiet) {
    fmt::print(stderr, "waiting for frames {}\n",
               arguments.tracking.sequence.is_pipe()
                   ? "on standard input"
                   : "in " + arguments.tracking.sequence.dataset.string());
  }
  try {
    const auto followed = open_followed(arguments.tracking.sequence, options);
    return {followed.data, followed.frames, followed.clock, {}};
  } catch (const InputError&) {
    if (!InterruptGuard::requested()) throw;
    return {};
  }
}

RunInput open_input(const RunArguments& arguments, const TrackerOptions& options) {
  if (arguments.is_open_ended()) return open_followed_input(arguments);
  TimedSequence timed = open_timed(arguments.tracking.sequence, options);
  RunInput input{std::move(timed.data), nullptr, std::move(timed.clock), {}};
  input.range = arguments.tracking.range(input.data->size());
  input.frames = std::make_shared<FramePrefetcher>(*input.data, input.range.begin, input.range.end,
                                                   input.range.step);
  return input;
}

int exit_code_of(int signal) { return signal == SIGTERM ? kTerminated : kInterrupted; }

int run(const RunArguments& arguments) {
  check_map_arguments(arguments);
  if (arguments.end_after && !arguments.follow) {
    throw OptionError("--end-after is for --follow: other recordings end with their last frame");
  }
  ProgramOptions options = arguments.tracking.options();
  options.slam.loops.enabled = arguments.mode == "slam";
  options.slam.loops.keep_rejected_matches |= arguments.loop_pictures == LoopPictures::kAll;
  if (arguments.dump_config) {
    fmt::print("{}", options_to_yaml(describe(options), true));
    return kDone;
  }
  const InterruptGuard interrupt;
  const auto vocabulary = vocabulary_of(arguments);
  const RunInput input = open_input(arguments, options.slam.tracker);
  const auto& data = input.data;
  if (!data) return exit_code_of(InterruptGuard::signal());
  std::vector<std::string> notes;
  const auto loaded = loaded_map(arguments, data->camera(), notes);
  const auto folder = arguments.out.empty() ? default_folder(data->name()) : arguments.out;
  prepare_folder(folder, arguments.overwrite);
  write_tum(folder / "trajectory.txt", {});  // proves that it can, before hours of work

  RunReport report{
      *data, input.clock, input.range,  options,          arguments.mode,         {}, std::nullopt,
      {},    {},          std::nullopt, std::move(notes), arguments.loop_pictures};
  const FrameStream stream{*input.frames, data->camera(), input.range.size()};
  const RunControl control{arguments.quiet, arguments.no_map ? 0 : options.map.pixel_step,
                           arguments.save_map};
  if (loaded) report.map_use = loaded->use;
  if (arguments.mode != "odometry") {
    SlamRun slam = run_slam(stream, options, vocabulary, control, loaded);
    report.saved_map = std::move(slam.map);
    report.run = std::move(slam.run);
    report.trajectory = std::move(slam.trajectory);
    report.graph = std::move(slam.graph);
  } else {
    report.run = run_odometry(stream, options.slam.tracker, control);
    report.trajectory = to_trajectory(report.run.records);
  }
  if (arguments.is_open_ended()) report.range.end = data->size();
  if (report.run.records.empty() && report.run.signal == 0) {
    const auto& said = data->notes();
    throw InputError(data->name(), "ended before a frame came" +
                                       (said.empty() ? std::string() : "; " + said.back()));
  }
  report.notes.insert(report.notes.begin(), data->notes().begin(), data->notes().end());
  report.map = make_run_map(report.run, report.graph, report.trajectory, data->camera(),
                            options.map, options.slam.tracker.threads);
  if (report.saved_map) add_surface(report, loaded);
  report.evaluation = evaluate_run(*data, report.trajectory, report.notes);
  if (const auto warning = agreement_warning(*data, report.trajectory)) {
    report.notes.push_back(*warning);
  }
  deliver(arguments, report, folder);
  if (report.run.signal != 0) return exit_code_of(report.run.signal);
  if (report.run.unusable) {
    throw InputError(data->name(),
                     fmt::format("none of the first {} frames can be used: {}",
                                 report.run.records.size(), report.run.records.front().reason));
  }
  return report.lost_share() > arguments.max_lost ? kTrackingLost : kDone;
}

}  // namespace

void add_run_command(CLI::App& app, Action& action) {
  const auto arguments = std::make_shared<RunArguments>();
  Command command(
      app, "run",
      "Track a sequence; write trajectory, map, plots and a report. With - as the dataset, pairs "
      "of images are named on standard input, lines 'stamp file stamp file'");
  arguments->tracking.add_to(command);
  command
      .add("--mode", &arguments->mode,
           "odometry = the tracker alone; graph = also optimise a graph of keyframes; slam = also "
           "recognise places and close loops")
      .one_of({"odometry", "graph", "slam"})
      .show_default();
  command.add(
      "--vocabulary", &arguments->vocabulary,
      "Vocabulary file for --mode slam, ours or the text format of ORB-SLAM (default: built "
      "in)");
  command.add("--out", &arguments->out,
              "Folder for the files (default results/<sequence>/<time>, linked as latest)");
  command
      .add("--max-lost", &arguments->max_lost,
           "Share of lost frames above which the exit code is 3")
      .in_range(0.0, 1.0)
      .show_default();
  command.add("--dump-config", &arguments->dump_config,
              "Print the effective options as YAML with their documentation, and stop");
  command.add("--follow", &arguments->follow,
              "The folder is still being written: take frames as they appear, until nothing has "
              "changed for --end-after or the run is interrupted");
  command
      .add("--end-after", &arguments->end_after,
           "Time without a change after which a recording with --follow has ended [s] (default 10)")
      .in_range(0.001, 1e6);
  command.add("--no-map", &arguments->no_map,
              "Write neither map.ply nor map.png: saves their memory and time");
  command.add("--save-map", &arguments->save_map,
              "Also write the folder map, from which --load-map goes on");
  command.add(
      "--load-map", &arguments->load_map,
      "Go on from a map that --save-map wrote, with the same camera: new frames add to it, in "
      "its world as soon as enough keyframes say where they are");
  command.add("--localize", &arguments->localize,
              "Leave the map of --load-map as it is, and only locate the frames in it");
  command.add_choice<LoopPictures, LoopPictures>(
      "--loop-pictures", &arguments->loop_pictures,
      {{"none", LoopPictures::kNone},
       {"accepted", LoopPictures::kAccepted},
       {"all", LoopPictures::kAll}},
      "none, accepted or all: the loop candidates whose images are drawn into the folder loops "
      "(default accepted)");
  command.add("--overwrite", &arguments->overwrite,
              "Write into a folder that has other files, too: those with the names of a run's are "
              "replaced");
  command.add("--quiet", &arguments->quiet, "Show no progress and no table");
  command.add("--json", &arguments->json, "Print the report as JSON instead of the table");
  command.on_parsed(action, [arguments] { return run(*arguments); });
}

}  // namespace cvo_slam
