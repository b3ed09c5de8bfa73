// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <numeric>
#include <vector>

#include <fmt/format.h>

#include "cvo_slam/apps/page/html.h"
#include "cvo_slam/apps/page/run_sections.h"
#include "cvo_slam/core/trajectory_errors.h"

namespace cvo_slam {
namespace {

using html::Cell;

std::string seconds(double value) { return fmt::format("{:.2f}", value); }

std::vector<std::string> frame_row(const std::string& stage, const std::vector<FrameCost>& costs,
                                   double FrameCost::*cost) {
  std::vector<double> values;
  values.reserve(costs.size());
  for (const FrameCost& frame : costs) values.push_back(frame.*cost);
  if (values.empty()) return {stage, "wall", "0", "", ""};
  const double sum = std::accumulate(values.begin(), values.end(), 0.0);
  const Statistics statistics = summarize(values);
  return {stage, "wall", seconds(sum / 1000), fmt::format("{:.1f}", statistics.median),
          fmt::format("{:.1f}", statistics.max)};
}

void add_graph_rows(const GraphStatistics& statistics, html::Table& table) {
  table.add(
      {fmt::format("optimising the newest part of the graph, {} times", statistics.window_solves),
       "wall", seconds(statistics.window_seconds), "", ""});
  table.add({fmt::format("optimising the whole graph, {} times", statistics.full_solves), "wall",
             seconds(statistics.full_seconds), "", ""});
}

}  // namespace

std::string cost_section(const RunReport& report) {
  const OdometryRun& run = report.run;
  html::Table table({{"stage"},
                     {"clock"},
                     {"all [s]", Cell::kNumber},
                     {"median of a frame [ms]", Cell::kNumber},
                     {"longest [ms]", Cell::kNumber}});
  table.add(frame_row("waiting for images", run.costs, &FrameCost::read_ms));
  table.add(frame_row(report.graph ? "tracking, with the graph" : "tracking", run.costs,
                      &FrameCost::track_ms));
  if (report.graph) add_graph_rows(report.graph->statistics, table);
  table.add({"all frames", "wall", seconds(run.seconds), "", ""});
  table.add({"all frames, reading ahead included", "CPU", seconds(run.cpu_seconds), "", ""});
  if (report.map.has_points) {
    table.add({"map and its picture", "CPU", seconds(report.map.cpu_seconds), "", ""});
  }
  const auto text = fmt::format("{:.1f} frames a second; at most {:.0f} MB of memory.", run.fps(),
                                run.peak_memory_mb);
  return html::section("cost", "Time and memory", html::paragraph(text) + table.content());
}

}  // namespace cvo_slam
