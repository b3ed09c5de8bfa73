// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/run_files.h"

#include <array>
#include <system_error>
#include <utility>
#include <vector>

#include "cvo_slam/apps/evaluation_plots.h"
#include "cvo_slam/apps/graph_report.h"
#include "cvo_slam/apps/loop_pictures.h"
#include "cvo_slam/apps/page/run_page.h"
#include "cvo_slam/apps/report_json.h"
#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/io/map_files.h"
#include "cvo_slam/io/options_file.h"
#include "cvo_slam/io/trajectory_files.h"
#include "cvo_slam/plot/trajectory_plot.h"

namespace cvo_slam {
namespace {

constexpr std::array kFiles = {
    RunFile{"report.html", "this page"},
    RunFile{"report.json", "all figures, for programs"},
    RunFile{"trajectory.txt", "the path of the camera, TUM format, lost frames as comments"},
    RunFile{"trajectory_online.txt", "the pose of each frame as it was known at its time"},
    RunFile{"frames.csv", "one line for each frame: status, reason, overlap, iterations, time"},
    RunFile{"loops.csv", "one line for each loop candidate: scores, verdict, reason"},
    RunFile{"keyframes.txt", "poses of the keyframes, TUM format"},
    RunFile{"graph.g2o", "the pose graph"},
    RunFile{"edges.txt", "the kinds of the graph's edges"},
    RunFile{"map.ply", "the points of the map with colours and normals"},
    RunFile{"map.png", "the map with the path"},
    RunFile{"trajectory.png", "the path from above, from the front and from the side"},
    RunFile{"trajectory.svg", "the same as vector graphics"},
    RunFile{"errors.png", "errors over time"},
    RunFile{"errors.svg", "the same as vector graphics"},
    RunFile{"config.yaml", "the options of this run, for --config"},
};

/// Tells the folder of a run from one with files of the same names.
constexpr const char* kMark = ".cvo_slam_run";
constexpr const char* kMapFolder = "map";

/// Returns the poses that track() returned at the time, of all submaps.
Trajectory answers_of_track(const std::vector<FrameRecord>& records) {
  Trajectory trajectory;
  for (const auto& record : records) {
    if (record.status == TrackingStatus::kTracked) {
      trajectory.poses.push_back({record.stamp, record.T_world_camera});
    } else {
      trajectory.lost.push_back({record.stamp, record.reason});
    }
  }
  return trajectory;
}

std::vector<NamedFigure> figures_of(const RunReport& report) {
  const auto& poses = report.trajectory.poses;
  if (!report.evaluation) return {{"trajectory", trajectory_figure({}, poses)}};
  return evaluation_figures(report.data.reference(), poses, *report.evaluation);
}

/// The candidates whose images are those of the sequence, by its frames: not those with a keyframe
/// of a map that was loaded.
std::vector<LoopCandidate> candidates_in_sequence(const GraphResult& graph) {
  std::vector<LoopCandidate> candidates;
  for (LoopCandidate candidate : graph.candidates) {
    if (candidate.from < graph.first_number) continue;
    candidate.from -= graph.first_number;
    candidate.to -= graph.first_number;
    candidates.push_back(std::move(candidate));
  }
  return candidates;
}

/// Removes the files that an earlier run left in the folder.
void remove_run(const std::filesystem::path& folder) {
  for (const RunFile& run_file : kFiles) {
    const auto file = folder / run_file.name;
    std::error_code ignored;
    // A folder of that name does not belong to a run.
    if (std::filesystem::is_directory(std::filesystem::symlink_status(file, ignored))) continue;
    remove_file(file);
  }
  remove_loop_pictures(folder);
}

}  // namespace

std::span<const RunFile> run_files() { return kFiles; }

void prepare_folder(const std::filesystem::path& folder, bool overwrite) {
  make_folder(folder);
  const auto mark = folder / kMark;
  if (!overwrite && !std::filesystem::is_empty(folder) && !std::filesystem::exists(mark)) {
    throw OutputError(folder,
                      "has files that are not those of a run; choose another folder, or "
                      "give --overwrite to replace files of the names that a run writes");
  }
  write_file(mark, "This folder belongs to a run of cvo_slam; the next one replaces its files.\n");
  remove_run(folder);
}

void write_run(const std::filesystem::path& folder, RunReport& report) {
  write_tum(folder / "trajectory.txt", report.trajectory);
  write_tum(folder / "trajectory_online.txt", answers_of_track(report.run.records));
  write_file(folder / "frames.csv", frames_csv(report.run));
  ProgramOptions options = report.options;
  write_file(folder / "config.yaml", options_to_yaml(describe(options), true));
  RunPictures pictures;
  if (report.graph) {
    write_loops(folder, *report.graph);
    pictures.loops = write_loop_pictures(folder, report.data, candidates_in_sequence(*report.graph),
                                         report.loop_pictures, kMostLoopsOnPage, report.notes);
  }
  pictures.map =
      write_run_map(folder, report.map, report.trajectory, report.data.reference(), report.notes);
  if (report.saved_map) write_map(folder / kMapFolder, *report.saved_map);
  write_file(folder / "report.json", json_text(report) + "\n");
  pictures.figures = figures_of(report);
  write_figures(folder, pictures.figures);
  write_file(folder / "report.html", run_page(folder, report, pictures));
}

}  // namespace cvo_slam
