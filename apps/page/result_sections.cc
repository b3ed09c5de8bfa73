// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "cvo_slam/apps/page/html.h"
#include "cvo_slam/apps/page/reasons.h"
#include "cvo_slam/apps/page/run_sections.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/plot/figure.h"

namespace cvo_slam {
namespace {

using html::Cell;

std::string map_picture(const RunReport& report, const cv::Mat& picture) {
  if (picture.empty()) {
    return html::paragraph("No picture of the map: none was asked for, or there was no keyframe.");
  }
  const auto caption =
      fmt::format("{} points of {} keyframes, and the camera's path, coloured by time.",
                  fmt::group_digits(report.map.map.points.size()), report.map.map.keyframes.size());
  return html::figure(html::jpeg_image(picture, "The map with the camera's path"), caption);
}

/// Returns the figure of that name, or nothing if the run has none.
std::string plot_named(const RunPictures& pictures, std::string_view name,
                       const std::string& caption) {
  for (const NamedFigure& named : pictures.figures) {
    if (named.name == name) return plot(named.figure, caption);
  }
  return {};
}

std::vector<std::string> error_row(const std::string& name, const PoseErrorStatistics& statistics) {
  const Statistics translation = in_unit(statistics.translation, 1000);
  const Statistics rotation = in_unit(statistics.rotation, kDegrees);
  std::vector<std::string> row = {name, fmt::to_string(translation.count)};
  for (const double value :
       {translation.rmse, translation.mean, translation.median, translation.max}) {
    row.push_back(fmt::format("{:.1f}", value));
  }
  for (const double value : {rotation.rmse, rotation.mean, rotation.median, rotation.max}) {
    row.push_back(fmt::format("{:.3f}", value));
  }
  return row;
}

std::string error_table(const EvaluationReport& evaluation) {
  html::Table table({{"error"},
                     {"pairs", Cell::kNumber},
                     {"RMSE [mm]", Cell::kNumber},
                     {"mean", Cell::kNumber},
                     {"median", Cell::kNumber},
                     {"max", Cell::kNumber},
                     {"RMSE [deg]", Cell::kNumber},
                     {"mean", Cell::kNumber},
                     {"median", Cell::kNumber},
                     {"max", Cell::kNumber}});
  if (evaluation.ate) table.add(error_row("ATE", evaluation.ate->statistics));
  for (const RelativeEvaluation& relative : evaluation.relative) {
    if (!relative.error) continue;
    table.add(error_row(label_of(relative.options), relative.error->statistics));
  }
  return table.content();
}

constexpr std::size_t kMostRows = 100;

/// Plots a figure of each registration over time; the line is broken where there was none.
Series over_time(const std::vector<FrameRecord>& records, double RegistrationResult::*value) {
  Series series;
  series.width = 1.2;
  for (const FrameRecord& record : records) {
    const bool registered = record.status == TrackingStatus::kTracked &&
                            record.registration.status != RegistrationStatus::kFailed;
    series.x.push_back(seconds_between(records.front().stamp, record.stamp));
    series.y.push_back(registered ? record.registration.*value
                                  : std::numeric_limits<double>::quiet_NaN());
  }
  return series;
}

Series lost_frames(const std::vector<FrameRecord>& records) {
  Series series{"lost", {}, {}, kVermilion, SeriesStyle::kPoints, 3};
  for (const FrameRecord& record : records) {
    if (record.status == TrackingStatus::kTracked) continue;
    series.x.push_back(seconds_between(records.front().stamp, record.stamp));
    series.y.push_back(0);
  }
  return series;
}

Figure tracking_figure(const std::vector<FrameRecord>& records) {
  Figure figure;
  figure.columns = 2;
  figure.width = 1500;
  figure.height = 300;
  const auto add = [&](const char* title, const char* label, double RegistrationResult::*value) {
    Panel panel{title, "time [s]", label, {over_time(records, value)}, false, true};
    Series lost = lost_frames(records);
    if (!lost.x.empty()) panel.series.push_back(std::move(lost));
    figure.panels.push_back(std::move(panel));
  };
  add("Overlap with the keyframe", "share of points", &RegistrationResult::overlap);
  add("Similarity of the two clouds", "cos_theta", &RegistrationResult::cos_theta);
  return figure;
}

std::string frames_text(const LostSpan& span) {
  return span.first == span.last ? fmt::to_string(span.first)
                                 : fmt::format("{} to {}", span.first, span.last);
}

std::string lost_table(const RunReport& report) {
  const auto spans = lost_spans(report.run.records, report.trajectory.lost);
  if (spans.empty()) return html::paragraph("No frame was lost.");
  html::Table table({{"frames"}, {"from [s]"}, {"number", Cell::kNumber}, {"reason of the first"}});
  for (std::size_t i = 0; i < std::min(spans.size(), kMostRows); ++i) {
    table.add({frames_text(spans[i]), spans[i].stamp.to_string(), fmt::to_string(spans[i].count),
               spans[i].first_reason});
  }
  std::string content = html::element("h3", "Lost frames") + table.content();
  if (spans.size() > kMostRows) {
    content += html::paragraph(
        fmt::format("{} more such intervals are in frames.csv.", spans.size() - kMostRows));
  }
  return content;
}

}  // namespace

std::string plot(const Figure& figure, const std::string& caption) {
  constexpr std::size_t kMostBytes = 1'000'000;
  std::string svg = to_svg(figure);
  if (svg.size() > kMostBytes) {
    const auto image = fmt::format(R"(<img alt="{}" src="{}">)", html::escaped(caption),
                                   html::data_uri("image/png", to_png(figure)));
    return html::figure(image, caption);
  }
  svg.erase(0, svg.find("<svg"));  // within a page there is no XML declaration
  return html::figure(svg, caption);
}

std::string map_section(const RunReport& report, const RunPictures& pictures) {
  return html::section("map", "Map and path",
                       map_picture(report, pictures.map) +
                           plot_named(pictures, "trajectory",
                                      "The path from above, from the front and from the side."));
}

std::string accuracy_section(const RunReport& report, const RunPictures& pictures) {
  if (!report.evaluation) return {};
  const EvaluationReport& evaluation = *report.evaluation;
  const auto how = fmt::format(
      "{} of {} poses have a match in the ground truth; {} alignment. ATE is the distance between "
      "the "
      "path and the true path, RPE the difference between the motion over an interval and the true "
      "motion.",
      evaluation.matches, evaluation.estimate_poses, name_of(evaluation.options.alignment));
  return html::section(
      "accuracy", "Accuracy",
      html::paragraph(how) + error_table(evaluation) +
          plot_named(pictures, "errors", "Errors over the time since the first frame."));
}

std::string tracking_section(const RunReport& report) {
  std::string content;
  if (!report.run.records.empty()) {
    content +=
        plot(tracking_figure(report.run.records),
             "The registration of each frame to its keyframe. The overlap falls while the camera "
             "moves away from a keyframe, and rises when a new one is made.");
  }
  return html::section("tracking", "Tracking", content + lost_table(report));
}

}  // namespace cvo_slam
