// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "cvo_slam/apps/graph_report.h"
#include "cvo_slam/apps/page/html.h"
#include "cvo_slam/apps/page/run_sections.h"
#include "cvo_slam/core/options.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/core/trajectory_errors.h"

namespace cvo_slam {
namespace {

using html::Cell;

/// Returns a figure in large print.
std::string tile(std::string_view name, std::string_view value, std::string_view detail,
                 bool is_bad = false) {
  return html::element(
      "div",
      html::element("dt", html::escaped(name)) +
          html::element("dd", html::element("b", html::escaped(value)) + html::escaped(detail)),
      is_bad ? R"(class="bad")" : "");
}

std::string tracked_tile(const RunReport& report) {
  const std::size_t frames = report.run.records.size();
  const std::size_t lost = report.trajectory.lost.size();
  return tile("Tracked", fmt::format("{:.1f} %", 100 * (1 - report.lost_share())),
              fmt::format("{} of {} frames", frames - lost, frames), lost > 0);
}

std::string error_tiles(const EvaluationReport& evaluation) {
  std::string tiles;
  if (evaluation.ate) {
    tiles += tile("ATE", length_text(evaluation.ate->statistics.translation.rmse),
                  fmt::format("RMSE over {} poses", evaluation.matches));
  }
  for (const RelativeEvaluation& relative : evaluation.relative) {
    if (!relative.error) continue;
    const auto& statistics = relative.error->statistics;
    tiles += tile(label_of(relative.options), length_text(statistics.translation.rmse),
                  fmt::format("{:.2f} deg", kDegrees * statistics.rotation.rmse));
  }
  return tiles;
}

std::string graph_tiles(const GraphResult& graph) {
  const auto count = [&](EdgeKind kind) { return edges_of_kind(graph.graph, kind); };
  return tile("Loops closed", fmt::to_string(count(EdgeKind::kLoop)), "recognised places") +
         tile("Constraints", fmt::to_string(graph.graph.edges().size()),
              fmt::format("{} between near keyframes", count(EdgeKind::kProximity)));
}

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

std::string headline(const RunReport& report) {
  std::string tiles = tracked_tile(report);
  if (report.evaluation) tiles += error_tiles(*report.evaluation);
  tiles += tile("Path", length_text(path_length(report.trajectory.poses)), "length of the path");
  tiles += tile("Keyframes", fmt::to_string(report.run.keyframes()), "of the tracked frames");
  if (report.graph) tiles += graph_tiles(*report.graph);
  return html::element("dl", tiles, R"(class="tiles")");
}

std::string notes_section(const RunReport& report) {
  std::vector<std::string> notes = report.all_notes();
  if (report.run.signal != 0) notes.insert(notes.begin(), "interrupted: results until then");
  if (notes.empty()) return {};
  std::string items;
  for (const std::string& note : notes) items += html::element("li", html::escaped(note));
  return html::section("notes", "Notes", html::element("ul", items));
}

std::string length_text(double metres) {
  return metres < 1 ? fmt::format("{:.1f} mm", kMillimetres * metres)
                    : fmt::format("{:.2f} m", metres);
}

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

std::string options_section(const RunReport& report) {
  ProgramOptions used = report.options;
  ProgramOptions defaults;
  const OptionSet default_set = describe(defaults);
  html::Table changed({{"option", Cell::kCode},
                       {"value", Cell::kCode},
                       {"default", Cell::kCode},
                       {"unit"},
                       {"what it is"}});
  html::Table unchanged(
      {{"option", Cell::kCode}, {"value", Cell::kCode}, {"unit"}, {"what it is"}});
  std::size_t count = 0;
  for (const Option& option : describe(used).options()) {
    const std::string value = option.get();
    const std::string usual = default_set.get(option.key);
    if (value == usual) {
      unchanged.add({option.key, value, option.unit, option.doc});
    } else {
      changed.add({option.key, value, usual, option.unit, option.doc});
      ++count;
    }
  }
  std::string content =
      count == 0 ? html::paragraph("All options are the defaults.")
                 : html::paragraph(fmt::format("{} {} not the default:", count,
                                               count == 1 ? "option is" : "options are")) +
                       changed.content();
  content +=
      html::element("details", html::element("summary", "The options that are the defaults") +
                                   unchanged.content());
  return html::section("options", "Options", content);
}

}  // namespace cvo_slam
