// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "cvo_slam/apps/graph_report.h"
#include "cvo_slam/apps/page/html.h"
#include "cvo_slam/apps/page/run_sections.h"
#include "cvo_slam/core/se3.h"

namespace cvo_slam {
namespace {

/// A figure to be seen from afar.
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
  return tile("Loops closed", fmt::to_string(count(EdgeKind::kLoop)), "places recognised") +
         tile("Constraints", fmt::to_string(graph.graph.edges().size()),
              fmt::format("{} of near keyframes", count(EdgeKind::kProximity)));
}

}  // namespace

std::string headline(const RunReport& report) {
  std::string tiles = tracked_tile(report);
  if (report.evaluation) tiles += error_tiles(*report.evaluation);
  tiles += tile("Path", length_text(path_length(report.trajectory.poses)), "camera travelled");
  tiles += tile("Keyframes", fmt::to_string(report.run.keyframes()), "of the frames tracked");
  if (report.graph) tiles += graph_tiles(*report.graph);
  return html::element("dl", tiles, R"(class="tiles")");
}

std::string notes_section(const RunReport& report) {
  std::vector<std::string> notes = report.notes;
  if (report.evaluation) {
    notes.insert(notes.end(), report.evaluation->notes.begin(), report.evaluation->notes.end());
  }
  if (report.run.interrupted) notes.insert(notes.begin(), "interrupted: what there was until then");
  if (notes.empty()) return {};
  std::string items;
  for (const std::string& note : notes) items += html::element("li", html::escaped(note));
  return html::section("notes", "Notes", html::element("ul", items));
}

std::string length_text(double metres) {
  constexpr double kMillimetres = 1000;
  return metres < 1 ? fmt::format("{:.1f} mm", kMillimetres * metres)
                    : fmt::format("{:.2f} m", metres);
}

}  // namespace cvo_slam
