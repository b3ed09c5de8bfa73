// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/benchmark_report.h"

#include <algorithm>
#include <iterator>
#include <vector>

#include <fmt/format.h>

#include "cvo_slam/apps/evaluation_plots.h"
#include "cvo_slam/core/error.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/core/trajectory_errors.h"
#include "cvo_slam/plot/comparison_plot.h"

namespace cvo_slam {
namespace {

using Row = std::vector<std::string>;

constexpr double kMilliseconds = 1e3;

const Row& header() {
  static const Row row = {
      "system",   "RPE 1 s [mm]", "RPE 1 s [deg]", "RPE 1 frame [mm]", "RPE 1 frame [deg]",
      "ATE [mm]", "lost",         "wrong",         "CPU median [ms]",  "CPU mean [ms]"};
  return row;
}

/// Adds the two cells of a relative error: the RMSE of translation and of rotation.
void add_cells(const RelativeEvaluation& relative, Row& row) {
  if (!relative.error) {
    row.insert(row.end(), {"-", "-"});
    return;
  }
  const PoseErrorStatistics& statistics = relative.error->statistics;
  row.push_back(fmt::format("{:.1f}", statistics.translation.rmse * kMillimetres));
  row.push_back(fmt::format("{:.2f}", statistics.rotation.rmse * kDegrees));
}

void add_error_cells(const std::optional<EvaluationReport>& evaluation, Row& row) {
  if (!evaluation) {
    row.insert(row.end(), 5, "-");
    return;
  }
  for (const auto& relative : evaluation->relative) add_cells(relative, row);
  row.push_back(
      evaluation->ate
          ? fmt::format("{:.1f}", evaluation->ate->statistics.translation.rmse * kMillimetres)
          : "-");
}

Row row_of(const ContestantResult& result) {
  Row row = {result.name};
  if (!result.built_in) {
    row.emplace_back("not built in");
    row.resize(header().size(), "-");
    return row;
  }
  add_error_cells(result.evaluation, row);
  row.push_back(fmt::format("{}", result.lost));
  row.push_back(result.wrong ? fmt::format("{}", result.wrong->frames.size()) : "-");
  row.push_back(fmt::format("{:.1f}", result.cpu.median * kMilliseconds));
  row.push_back(fmt::format("{:.1f}", result.cpu.mean * kMilliseconds));
  return row;
}

/// Aligns names to the left and figures to the right.
std::string markdown_line(const Row& row, const std::vector<std::size_t>& widths) {
  std::string line = fmt::format("| {:<{}} |", row.front(), widths.front());
  for (std::size_t i = 1; i < row.size(); ++i) line += fmt::format(" {:>{}} |", row[i], widths[i]);
  return line + "\n";
}

std::string markdown_table(const std::vector<Row>& rows) {
  std::vector<std::size_t> widths;
  for (std::size_t column = 0; column < header().size(); ++column) {
    widths.push_back(header()[column].size());
    for (const Row& row : rows) widths.back() = std::max(widths.back(), row[column].size());
  }
  Row rule = {std::string(widths.front(), '-')};
  for (std::size_t i = 1; i < widths.size(); ++i) {
    rule.push_back(std::string(widths[i] - 1, '-') + ":");  // aligned to the right
  }
  std::string text = markdown_line(header(), widths) + markdown_line(rule, widths);
  for (const Row& row : rows) text += markdown_line(row, widths);
  return text;
}

ComparedTrajectory compared(const std::vector<StampedPose>& reference,
                            const ContestantResult& result) {
  const auto& ate = result.evaluation ? result.evaluation->ate : std::nullopt;
  const Similarity alignment = ate ? ate->alignment : Similarity();
  const auto matches = associate(reference, result.poses, {.interpolate = true});
  return {result.name, transformed(alignment, result.poses),
          relative_pose_error(matches, cvo_paper_options()).errors};
}

/// Cumulative distributions of the errors from frame to frame by the measure of the CVO paper, and
/// top views, of the systems that are built in. Unlike those of the table, these errors are against
/// the reference interpolated at the stamps of the frames: between two frames the distance to the
/// nearest sample is as large as the motion.
Figure benchmark_figure(const Dataset& data, const OdometryBenchmark& benchmark) {
  std::vector<StampedPose> reference;
  std::vector<ComparedTrajectory> estimates;
  for (const ContestantResult& result : benchmark.results) {
    if (!result.built_in || result.poses.empty()) continue;
    if (reference.empty()) reference = reference_during(data.reference(), result.poses);
    estimates.push_back(compared(data.reference(), result));
  }
  if (estimates.empty()) throw DataError("no system of the comparison is built in");
  return comparison_figure(reference, estimates);
}

}  // namespace

std::string_view benchmark_protocol() {
  return "RMSE, stamps matched to the nearest within 20 ms; RPE 1 s: all pairs; ATE: after "
         "alignment by a rigid motion; a lost frame keeps the pose before it; wrong: frames that "
         "are called tracked although their motion since the last right one is off by more than "
         "10 cm or 5 degrees from the interpolated reference; CPU: time of the one thread a "
         "frame, images decoded";
}

std::string to_table(const Dataset& data, const OdometryBenchmark& benchmark) {
  std::vector<Row> rows;
  std::transform(benchmark.results.begin(), benchmark.results.end(), std::back_inserter(rows),
                 row_of);
  const FrameRange& frames = benchmark.frames;
  const std::string step = frames.step == 1 ? "" : fmt::format(", 1 of {}", frames.step);
  std::string text =
      fmt::format("- sequence: {} ({}), frames {} to {} of {}{}, camera {}\n", data.name(),
                  data.kind(), frames.begin, frames.end - 1, data.size(), step, data.camera().name);
  if (!benchmark.depth_offset.empty()) {
    text += fmt::format("- depth offset: {}\n", benchmark.depth_offset);
  }
  text += fmt::format("- protocol: {}\n", benchmark_protocol());
  text += fmt::format(
      "- decoding a frame's images: median {:.1f} ms, mean {:.1f} ms of CPU, in no row below\n",
      benchmark.decoding.median * kMilliseconds, benchmark.decoding.mean * kMilliseconds);
  for (const auto& result : benchmark.results) {
    text += fmt::format("- {}: {}\n", result.name, result.description);
  }
  return text + "\n" + markdown_table(rows);
}

void write_benchmark_plots(const std::filesystem::path& folder, const Dataset& data,
                           const OdometryBenchmark& benchmark) {
  write_figure(folder / "odometry", benchmark_figure(data, benchmark));
}

}  // namespace cvo_slam
