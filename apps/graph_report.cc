// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/graph_report.h"

#include <algorithm>

#include <fmt/format.h>

#include "cvo_slam/core/files.h"

namespace cvo_slam {
namespace {

/// Returns the columns of place recognition; empty if the pair was found in another way.
std::string recognition_fields(const LoopCandidate& c) {
  if (c.kind != EdgeKind::kLoop) return ",,";
  return fmt::format("{:.4f},{:.3f},{}", c.score, c.normalized_score, c.inliers);
}

/// Returns the columns of the registration; empty if the candidate was rejected before it.
std::string registration_fields(const LoopCandidate& c) {
  if (c.overlap == 0) return ",,,";
  return fmt::format("{:.4f},{:.4f},{:.5f},{:.5f}", c.overlap, c.cos_theta,
                     c.round_trip_translation, c.round_trip_rotation);
}

/// Returns the columns of the comparison with the graph; empty if there was none.
std::string correction_fields(const LoopCandidate& c) {
  if (c.error == 0) return ",,";
  return fmt::format("{:.5f},{:.5f},{:.3f}", c.correction_translation, c.correction_rotation,
                     c.error);
}

auto accepted(const std::vector<LoopCandidate>& candidates) {
  return std::count_if(candidates.begin(), candidates.end(),
                       [](const LoopCandidate& candidate) { return candidate.accepted; });
}

}  // namespace

std::string_view name_of(const LoopCandidate& candidate) {
  if (candidate.relocalization) return "lost";
  switch (candidate.kind) {
    case EdgeKind::kOdometry:
      return "odometry";
    case EdgeKind::kProximity:
      return "proximity";
    case EdgeKind::kLoop:
      return "bow";
  }
  return "";
}

std::size_t edges_of_kind(const PoseGraph& graph, EdgeKind kind) {
  return static_cast<std::size_t>(
      std::count_if(graph.edges().begin(), graph.edges().end(),
                    [&](const PoseGraphEdge& edge) { return edge.kind == kind; }));
}

std::string csv_quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

std::string to_table(const GraphResult& result) {
  const GraphStatistics& statistics = result.statistics;
  return fmt::format(
      "{:<12} {} odometry edges, {} proximity edges, {} loop edges; {} of {} candidates accepted; "
      "solved in {:.2f} s\n",
      "graph", edges_of_kind(result.graph, EdgeKind::kOdometry),
      edges_of_kind(result.graph, EdgeKind::kProximity),
      edges_of_kind(result.graph, EdgeKind::kLoop), accepted(result.candidates),
      result.candidates.size(), statistics.window_seconds + statistics.full_seconds);
}

std::string loops_csv(const std::vector<LoopCandidate>& candidates) {
  std::string csv =
      "kind,from,to,score,normalized_score,inliers,expected_overlap,overlap,cos_theta,round_trip_m,"
      "round_trip_rad,correction_m,"
      "correction_rad,standard_deviations,verdict,reason\n";
  for (const LoopCandidate& c : candidates) {
    csv +=
        fmt::format("{},{},{},{},{},{},{},{},{}\n", name_of(c), c.from, c.to, recognition_fields(c),
                    c.expected_overlap ? fmt::format("{:.2f}", *c.expected_overlap) : "",
                    registration_fields(c), correction_fields(c),
                    c.accepted ? "accepted" : "rejected", csv_quoted(c.reason));
  }
  return csv;
}

void write_loops(const std::filesystem::path& folder, const GraphResult& result) {
  write_file(folder / "loops.csv", loops_csv(result.candidates));
}

}  // namespace cvo_slam
