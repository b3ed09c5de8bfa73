// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/run_files.h"

#include <array>
#include <system_error>

#include "cvo_slam/apps/loop_pictures.h"
#include "cvo_slam/core/files.h"

namespace cvo_slam {
namespace {

constexpr std::array kFiles = {
    RunFile{"report.html", "this page"},
    RunFile{"report.json", "all figures, for programs"},
    RunFile{"trajectory.txt", "the camera's path, TUM format, lost frames as comments"},
    RunFile{"trajectory_online.txt", "what was known of each frame at its time"},
    RunFile{"frames.csv", "a line a frame: status, reason, overlap, iterations, time"},
    RunFile{"loops.csv", "a line a candidate for a constraint: scores, verdict, reason"},
    RunFile{"keyframes.txt", "poses of the keyframes, TUM format"},
    RunFile{"graph.g2o", "the pose graph"},
    RunFile{"edges.txt", "the kinds of the graph's edges"},
    RunFile{"map.ply", "the map's points with colours and normals"},
    RunFile{"map.png", "the map with the path"},
    RunFile{"trajectory.png", "the path from above, in front and aside"},
    RunFile{"trajectory.svg", "the same by its lines"},
    RunFile{"errors.png", "errors over time"},
    RunFile{"errors.svg", "the same by its lines"},
    RunFile{"config.yaml", "the options of this run, for --config"},
};

}  // namespace

std::span<const RunFile> run_files() { return kFiles; }

void remove_run(const std::filesystem::path& folder) {
  for (const RunFile& run_file : kFiles) {
    const auto file = folder / run_file.name;
    std::error_code ignored;
    // A folder of that name is not a run's.
    if (std::filesystem::is_directory(std::filesystem::symlink_status(file, ignored))) continue;
    remove_file(file);
  }
  remove_loop_pictures(folder);
}

}  // namespace cvo_slam
