// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <string>
#include <vector>

#include <fmt/format.h>

#include "cvo_slam/apps/page/html.h"
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

/// The run's figure of that name, where it has one.
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

}  // namespace

std::string plot(const Figure& figure, const std::string& caption) {
  constexpr std::size_t kMostBytes = 1'000'000;
  std::string svg = to_svg(figure);
  if (svg.size() > kMostBytes) {
    const auto image = fmt::format("<img alt=\"{}\" src=\"{}\">", html::escaped(caption),
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
      "{} of {} poses have a partner in the ground truth; {} alignment. ATE is how far the path is "
      "from the true one, RPE how far the motion over a stretch is from the true motion.",
      evaluation.matches, evaluation.estimate_poses, name_of(evaluation.options.alignment));
  return html::section(
      "accuracy", "Accuracy",
      html::paragraph(how) + error_table(evaluation) +
          plot_named(pictures, "errors", "Errors over the time since the first frame."));
}

}  // namespace cvo_slam
