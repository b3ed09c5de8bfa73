// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/evaluation_plots.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>

#include "cvo_slam/core/files.h"
#include "cvo_slam/plot/figure.h"
#include "cvo_slam/plot/trajectory_plot.h"

namespace cvo_slam {
namespace {

std::vector<ErrorCurve> curves_of(const EvaluationReport& report) {
  std::vector<ErrorCurve> curves;
  if (report.ate) curves.push_back({"ATE", report.ate->errors});
  for (const auto& relative : report.relative) {
    if (relative.error) curves.push_back({label_of(relative.options), relative.error->errors});
  }
  return curves;
}

}  // namespace

std::vector<StampedPose> reference_during(const std::vector<StampedPose>& reference,
                                          const std::vector<StampedPose>& estimate, double offset) {
  const std::int64_t shift = std::llround(offset * 1e9);
  const std::int64_t begin = estimate.front().stamp.nanoseconds() + shift;
  const std::int64_t end = estimate.back().stamp.nanoseconds() + shift;
  std::vector<StampedPose> part;
  std::copy_if(reference.begin(), reference.end(), std::back_inserter(part),
               [&](const StampedPose& pose) {
                 return pose.stamp.nanoseconds() >= begin && pose.stamp.nanoseconds() <= end;
               });
  return part.empty() ? reference : part;
}

std::vector<NamedFigure> evaluation_figures(const std::vector<StampedPose>& reference,
                                            const std::vector<StampedPose>& estimate,
                                            const EvaluationReport& report) {
  const Similarity alignment = report.ate ? report.ate->alignment : Similarity();
  const double offset = report.options.association.time_offset;
  return {{"trajectory", trajectory_figure(reference_during(reference, estimate, offset),
                                           transformed(alignment, estimate))},
          {"errors", error_figure(curves_of(report))}};
}

void write_figures(const std::filesystem::path& folder, const std::vector<NamedFigure>& figures) {
  make_folder(folder);
  for (const NamedFigure& named : figures) {
    write_figure(folder / named.name, named.figure);
  }
}

}  // namespace cvo_slam
