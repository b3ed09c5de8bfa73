// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/evaluation_report.h"

#include <algorithm>
#include <array>
#include <cmath>
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

/// Returns a figure with six decimals, or in scientific notation if it would have more than seven
/// digits before the point.
std::string figure_text(double value) {
  constexpr double kLargest = 1e7;
  return std::fabs(value) < kLargest ? fmt::format("{:.6f}", value) : fmt::format("{:.6e}", value);
}

/// The cells of a row: its name, its quantity, and the figures.
using FigureRow = std::array<std::string, 10>;

FigureRow figure_row(std::string_view name, std::string_view quantity, const Statistics& s) {
  return {std::string(name),     std::string(quantity),  figure_text(s.rmse), figure_text(s.mean),
          figure_text(s.median), figure_text(s.std),     figure_text(s.min),  figure_text(s.max),
          figure_text(s.sse),    std::to_string(s.count)};
}

void add_figure_rows(std::vector<FigureRow>& rows, std::string_view name,
                     const PoseErrorStatistics& statistics) {
  rows.push_back(figure_row(name, "translation [m]", statistics.translation));
  rows.push_back(figure_row("", "rotation [deg]", in_unit(statistics.rotation, kDegrees)));
}

/// Returns the rows as lines whose columns are at least two blanks apart.
std::string aligned_rows(const std::vector<FigureRow>& rows) {
  std::array<std::size_t, 10> widths = {14, 17, 12, 12, 12, 12, 12, 12, 14, 8};
  for (const FigureRow& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size() + 2);
  }
  std::string text;
  for (const FigureRow& row : rows) {
    text += fmt::format("{:<{}}{:<{}}", row[0], widths[0], row[1], widths[1]);
    for (std::size_t i = 2; i < row.size(); ++i) text += fmt::format("{:>{}}", row[i], widths[i]);
    text += "\n";
  }
  return text;
}

/// From this share on, what is in no figure is a warning.
constexpr double kLargeShare = 0.1;

double share_of(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

void add_warning(EvaluationReport& report, const char* file, const LeftOutLines& left_out,
                 std::size_t poses) {
  if (share_of(left_out.total(), poses) < kLargeShare) return;
  std::string warning =
      fmt::format("{} of the {} poses of the {} are left out", left_out.total(), poses, file);
  if (left_out.repeated > 0) {
    warning += fmt::format(
        "; {} have the stamp of an earlier one: if stamps are rounded, write them with all their "
        "digits",
        left_out.repeated);
  }
  if (left_out.invalid > 0) warning += fmt::format("; {} are not finite", left_out.invalid);
  report.warnings.push_back(warning);
}

void add_warnings(EvaluationReport& report, std::size_t possible) {
  add_warning(report, "reference", report.left_out.reference, report.reference_poses);
  add_warning(report, "estimate", report.left_out.estimate, report.estimate_poses);
  if (share_of(possible - report.matches, possible) < kLargeShare) return;
  report.warnings.push_back(fmt::format(
      "{} of {} poses have no partner and are in no figure; check that both files are of the whole "
      "sequence and by the same clock",
      possible - report.matches, possible));
}

/// Returns the root mean square distance of the reference's positions from their mean [m].
double extent_of_reference(const std::vector<MatchedPose>& matches) {
  Vector3 mean = Vector3::Zero();
  for (const MatchedPose& match : matches) mean += match.reference.translation();
  mean /= static_cast<double>(matches.size());
  double sum = 0;
  for (const MatchedPose& match : matches) {
    sum += (match.reference.translation() - mean).squaredNorm();
  }
  return std::sqrt(sum / static_cast<double>(matches.size()));
}

/// Adds a warning if the estimate is of another size than the reference, as it is if depth is read
/// with a wrong scale.
void add_scale_warning(EvaluationReport& report, const std::vector<MatchedPose>& matches) {
  constexpr double kUnusual = 0.15;
  // A trajectory that drifts gains less by another size, and noise shrinks to nothing.
  constexpr double kBetter = 0.5;
  constexpr double kExplained = 0.1;
  if (!report.ate || report.options.alignment != Alignment::kSe3) return;
  try {
    const AbsoluteTrajectoryError scaled = absolute_trajectory_error(matches, Alignment::kSim3);
    const double scale = scaled.alignment.scale;
    if (std::fabs(std::log(scale)) < std::log1p(kUnusual) ||
        scaled.statistics.translation.rmse > kBetter * report.ate->statistics.translation.rmse ||
        scaled.statistics.translation.rmse > kExplained * extent_of_reference(matches)) {
      return;
    }
    report.warnings.push_back(fmt::format(
        "the reference is {:.2f} times as large as the estimate; is the depth_scale of the camera "
        "right?",
        scale));
  } catch (const DataError&) {  // no scale: positions on a line, or all the same
  }
}

std::string left_out_lines(const EvaluationReport& report) {
  std::string text;
  const auto add = [&](std::size_t count, const char* file, const char* why) {
    if (count > 0) text += fmt::format("left out   {} poses of the {}: {}\n", count, file, why);
  };
  constexpr const char* kRepeated = "the stamp is that of an earlier one";
  constexpr const char* kInvalid = "not finite, or a quaternion of length zero";
  add(report.left_out.reference.repeated, "reference", kRepeated);
  add(report.left_out.reference.invalid, "reference", kInvalid);
  add(report.left_out.estimate.repeated, "estimate", kRepeated);
  add(report.left_out.estimate.invalid, "estimate", kInvalid);
  add(report.unmatched, "estimate", "no pose of the reference at that time");
  return text;
}

/// Returns the number of poses of the estimate that have a partner; as several poses of a shorter
/// reference may take the same one, it can be lower than that of matches.
std::size_t count_matched(const std::vector<MatchedPose>& matches) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    if (i == 0 || matches[i].stamp != matches[i - 1].stamp) ++count;
  }
  return count;
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
                          const EvaluationOptions& options, const LeftOutOfFiles& left_out) {
  auto matches = associate(reference, estimate, options.association);
  EvaluationReport report;
  report.options = options;
  report.left_out = left_out;
  report.reference_poses = reference.size() + left_out.reference.total();
  report.estimate_poses = estimate.size() + left_out.estimate.total();
  report.matches = matches.size();
  report.unmatched = estimate.size() - count_matched(matches);
  const bool by_reference = !options.association.interpolate && reference.size() < estimate.size();
  report.coverage =
      share_of(matches.size(), by_reference ? report.reference_poses : report.estimate_poses);
  add_warnings(report, by_reference ? reference.size() : estimate.size());

  add_ate(report, matches);
  add_scale_warning(report, matches);
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
  const bool of_reference = report.coverage != share_of(report.matches, report.estimate_poses);
  std::string text = fmt::format(
      "matched    {} of {} poses ({:.1f} %{}) with {} of the reference, {}\n", report.matches,
      report.estimate_poses, 100 * report.coverage, of_reference ? " of the reference" : "",
      report.reference_poses, describe_association(report.options.association));
  text += left_out_lines(report);
  text += fmt::format("alignment  {}", name_of(report.options.alignment));
  if (report.ate && report.options.alignment == Alignment::kSim3) {
    text += fmt::format(", scale {:.9g}", report.ate->alignment.scale);
  }
  std::vector<FigureRow> rows = {
      {"", "", "rmse", "mean", "median", "std", "min", "max", "sse", "count"}};
  bool has_paper_error = false;
  if (report.ate) add_figure_rows(rows, "ATE", report.ate->statistics);
  for (const auto& relative : report.relative) {
    if (!relative.error) continue;
    add_figure_rows(rows, label_of(relative.options), relative.error->statistics);
    has_paper_error |= relative.options.kind == RelativeErrorKind::kCvoPaper;
  }
  text += "\n\n" + aligned_rows(rows);
  if (has_paper_error)
    text += "* as the CVO paper defines it: rotation is sqrt(2) times the angle\n";
  for (const auto& note : report.notes) text += note + "\n";
  for (const auto& warning : report.warnings) text += "warning: " + warning + "\n";
  if (report.at_best_offset) {
    text += "\nwith the offset between the clocks at which the rotations agree best:\n" +
            to_table(*report.at_best_offset);
  }
  return text;
}

}  // namespace cvo_slam
