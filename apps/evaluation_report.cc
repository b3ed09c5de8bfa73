// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/evaluation_report.h"

#include <algorithm>
#include <iterator>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/se3.h"

namespace cvo_slam {
namespace {

void scale_estimate(std::vector<MatchedPose>& matches, double scale) {
  const Similarity scaling{SE3(), scale};
  for (auto& match : matches) match.estimate = scaling * match.estimate;
}

void add_ate(EvaluationReport& report, const std::vector<MatchedPose>& matches) {
  try {
    report.ate = absolute_trajectory_error(matches, report.options.alignment);
  } catch (const DataError& error) {
    report.notes.push_back(fmt::format("no ATE: {}", error.what()));
  }
}

void add_relative(EvaluationReport& report, const std::vector<MatchedPose>& matches,
                  const RelativePoseOptions& options) {
  report.relative.push_back({options, std::nullopt});
  try {
    report.relative.back().error = relative_pose_error(matches, options);
  } catch (const DataError& error) {
    report.notes.push_back(fmt::format("no {}: {}", label_of(options), error.what()));
  }
}

bool has_figures(const EvaluationReport& report) {
  return report.ate || std::any_of(report.relative.begin(), report.relative.end(),
                                   [](const auto& relative) { return relative.error.has_value(); });
}

std::string table_row(std::string_view name, std::string_view quantity, const Statistics& s) {
  return fmt::format(
      "{:<14}{:<17}{:>12.6f}{:>12.6f}{:>12.6f}{:>12.6f}{:>12.6f}{:>12.6f}{:>14.6f}{:>8}\n", name,
      quantity, s.rmse, s.mean, s.median, s.std, s.min, s.max, s.sse, s.count);
}

std::string table_rows(std::string_view name, const PoseErrorStatistics& statistics) {
  return table_row(name, "translation [m]", statistics.translation) +
         table_row("", "rotation [deg]", in_unit(statistics.rotation, kDegrees));
}

std::string describe_association(const AssociationOptions& options) {
  const std::string offset =
      options.time_offset == 0
          ? ""
          : fmt::format(", stamps of the estimate shifted by {} s", options.time_offset);
  if (options.interpolate) return "reference interpolated" + offset;
  return fmt::format("nearest stamp within {} s{}", options.max_difference, offset);
}

}  // namespace

EvaluationReport evaluate(const std::vector<StampedPose>& reference,
                          const std::vector<StampedPose>& estimate,
                          const EvaluationOptions& options) {
  auto matches = associate(reference, estimate, options.association);
  EvaluationReport report;
  report.options = options;
  report.reference_poses = reference.size();
  report.estimate_poses = estimate.size();
  report.matches = matches.size();
  const std::size_t possible = options.association.interpolate
                                   ? estimate.size()
                                   : std::min(reference.size(), estimate.size());
  report.coverage = static_cast<double>(matches.size()) / static_cast<double>(possible);

  add_ate(report, matches);
  if (report.ate && report.ate->alignment.scale != 1) {
    scale_estimate(matches, report.ate->alignment.scale);
  }
  for (const auto& relative : options.relative) add_relative(report, matches, relative);
  if (!has_figures(report)) {
    throw DataError(fmt::format("nothing to evaluate; {}", fmt::join(report.notes, "; ")));
  }
  return report;
}

std::string_view name_of(Alignment alignment) {
  switch (alignment) {
    case Alignment::kNone:
      return "none";
    case Alignment::kSe3:
      return "se3";
    case Alignment::kSim3:
      return "sim3";
  }
  return "";
}

std::string label_of(const RelativePoseOptions& options) {
  const bool single_frame = options.unit == DeltaUnit::kFrames && options.delta == 1;
  return fmt::format("RPE {} {}{}", options.delta, single_frame ? "frame" : to_string(options.unit),
                     options.kind == RelativeErrorKind::kCvoPaper ? " *" : "");
}

std::string to_table(const EvaluationReport& report) {
  std::string text =
      fmt::format("matched    {} of {} poses ({:.1f} %) with {} of the reference, {}\n",
                  report.matches, report.estimate_poses, 100 * report.coverage,
                  report.reference_poses, describe_association(report.options.association));
  text += fmt::format("alignment  {}", name_of(report.options.alignment));
  if (report.ate && report.options.alignment == Alignment::kSim3) {
    text += fmt::format(", scale {:.9f}", report.ate->alignment.scale);
  }
  text += fmt::format("\n\n{:<31}{:>12}{:>12}{:>12}{:>12}{:>12}{:>12}{:>14}{:>8}\n", "", "rmse",
                      "mean", "median", "std", "min", "max", "sse", "count");
  bool has_paper_error = false;
  if (report.ate) text += table_rows("ATE", report.ate->statistics);
  for (const auto& relative : report.relative) {
    if (!relative.error) continue;
    text += table_rows(label_of(relative.options), relative.error->statistics);
    has_paper_error |= relative.options.kind == RelativeErrorKind::kCvoPaper;
  }
  if (has_paper_error)
    text += "* as the CVO paper defines it: rotation is sqrt(2) times the angle\n";
  for (const auto& note : report.notes) text += note + "\n";
  return text;
}

}  // namespace cvo_slam
