// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/run_report.h"

#include <algorithm>

#include <fmt/format.h>

#include "cvo_slam/apps/graph_report.h"
#include "cvo_slam/apps/page/run_page.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/core/trajectory_errors.h"
#include "cvo_slam/io/options_file.h"
#include "cvo_slam/io/trajectory_files.h"
#include "cvo_slam/plot/trajectory_plot.h"

namespace cvo_slam {
namespace {

/// Returns an empty word if the frame was not registered at all, as the first one.
std::string_view registration_word(const RegistrationResult& result) {
  switch (result.status) {
    case RegistrationStatus::kConverged:
      return "converged";
    case RegistrationStatus::kIterationLimit:
      return "iteration_limit";
    case RegistrationStatus::kFailed:
      return result.reason.empty() ? "" : "failed";
  }
  return "";
}

std::string share_of_keyframes(const GraphResult& graph) {
  return fmt::format(", {:.0f} MB of it for {} keyframes",
                     static_cast<double>(graph.statistics.keyframe_bytes) / kBytesOfMegabyte,
                     graph.keyframes.size());
}

/// What became of the keyframes that the map has no more; empty if it has all.
std::string removed_keyframes(const GraphResult& graph) {
  const GraphStatistics& statistics = graph.statistics;
  std::string text;
  if (statistics.redundant_keyframes > 0) {
    text += fmt::format(", {} removed as redundant", statistics.redundant_keyframes);
  }
  if (statistics.dropped_keyframes > 0) {
    text += fmt::format(", {} dropped for culling.max_memory", statistics.dropped_keyframes);
  }
  return text;
}

std::string error_rows(const EvaluationReport& evaluation) {
  std::string rows;
  if (evaluation.ate) {
    rows += fmt::format("{:<12} {:.4f} m after {} alignment, {} poses\n", "ATE",
                        evaluation.ate->statistics.translation.rmse,
                        name_of(evaluation.options.alignment), evaluation.matches);
  }
  for (const auto& relative : evaluation.relative) {
    if (!relative.error) continue;
    const auto& statistics = relative.error->statistics;
    rows += fmt::format("{:<12} {:.1f} mm, {:.2f} deg\n", label_of(relative.options),
                        1e3 * statistics.translation.rmse, kDegrees * statistics.rotation.rmse);
  }
  return rows;
}

}  // namespace

double median_cost(const OdometryRun& run, double FrameCost::*cost) {
  std::vector<double> values;
  for (const auto& frame : run.costs) values.push_back(frame.*cost);
  return summarize(values).median;
}

double RunReport::lost_share() const {
  if (run.records.empty()) return 0;
  std::size_t lost = trajectory.lost.size();
  if (map_use == MapUse::kLocalize) {
    lost = static_cast<std::size_t>(std::count_if(
        run.records.begin(), run.records.end(),
        [](const FrameRecord& record) { return record.status == TrackingStatus::kLost; }));
  }
  return static_cast<double>(lost) / static_cast<double>(run.records.size());
}

std::size_t RunReport::localized_frames() const {
  return static_cast<std::size_t>(
      std::count_if(run.records.begin(), run.records.end(),
                    [](const FrameRecord& record) { return record.localized; }));
}

std::vector<std::string> RunReport::all_notes() const {
  std::vector<std::string> all = notes;
  if (!evaluation) return all;
  for (const auto& warning : evaluation->warnings) all.push_back("warning: " + warning);
  all.insert(all.end(), evaluation->notes.begin(), evaluation->notes.end());
  return all;
}

std::string to_table(const RunReport& report) {
  const OdometryRun& run = report.run;
  std::string table =
      fmt::format("{:<12} {} ({})\n", "sequence", report.data.name(), report.data.kind());
  table += fmt::format("{:<12} {}: {}\n", "camera", report.data.camera().name,
                       report.data.camera_origin());
  table += fmt::format("{:<12} {}\n", "depth offset", report.clock.text());
  if (report.evaluation) table += error_rows(*report.evaluation);
  table += fmt::format("{:<12} {:.2f} m\n", "path", path_length(report.trajectory.poses));
  if (!run.records.empty()) {
    table += fmt::format("{:<12} {:.1f} fps; read {:.1f} ms, track {:.1f} ms a frame (median)\n",
                         "speed", run.fps(), median_cost(run, &FrameCost::read_ms),
                         median_cost(run, &FrameCost::track_ms));
  }
  table += fmt::format("{:<12} {:.1f} % ({} of {} frames)\n", "lost", 100 * report.lost_share(),
                       report.trajectory.lost.size(), run.records.size());
  if (!report.trajectory.lost.empty()) {
    const LostFrame& first = report.trajectory.lost.front();
    table += fmt::format("{:<12} at {}: {}\n", "first lost", first.stamp.to_string(), first.reason);
  }
  if (report.map_use && !run.records.empty()) {
    const std::size_t localized = report.localized_frames();
    table +=
        fmt::format("{:<12} {:.1f} % ({} of {} frames)\n", "localized",
                    100 * static_cast<double>(localized) / static_cast<double>(run.records.size()),
                    localized, run.records.size());
  }
  table += fmt::format("{:<12} {}{}\n", "keyframes", run.keyframes(),
                       report.graph ? removed_keyframes(*report.graph) : "");
  if (report.graph) table += to_table(*report.graph);
  if (report.map.has_points) {
    table += fmt::format("{:<12} {} points, made and drawn in {:.1f} s of CPU\n", "map",
                         report.map.map.points.size(), report.map.cpu_seconds);
  }
  table += fmt::format("{:<12} {:.0f} MB{}\n", "peak memory", run.peak_memory_mb,
                       report.graph ? share_of_keyframes(*report.graph) : "");
  for (const auto& note : report.all_notes()) table += fmt::format("{:<12} {}\n", "note", note);
  return table;
}

std::string frames_csv(const OdometryRun& run) {
  std::string csv =
      "index,stamp,status,reason,submap,keyframe,keyframe_reason,points,registration,overlap,"
      "cos_theta,iterations,read_ms,track_ms,localized,doubt\n";
  for (std::size_t i = 0; i < run.records.size(); ++i) {
    const FrameRecord& r = run.records[i];
    csv += fmt::format("{},{},{},{},{},{},{},{},{},{:.4f},{:.4f},{},{:.3f},{:.3f},{},{:.4f}\n",
                       r.index, r.stamp.to_string(),
                       r.status == TrackingStatus::kTracked ? "tracked" : "lost",
                       csv_quoted(r.reason), r.submap, r.keyframe, csv_quoted(r.keyframe_reason),
                       r.points, registration_word(r.registration), r.registration.overlap,
                       r.registration.cos_theta, r.registration.iterations, run.costs[i].read_ms,
                       run.costs[i].track_ms, r.localized ? 1 : 0, r.doubt);
  }
  return csv;
}

}  // namespace cvo_slam
