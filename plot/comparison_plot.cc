// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/plot/comparison_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "cvo_slam/core/se3.h"
#include "cvo_slam/plot/trajectory_plot.h"

namespace cvo_slam {
namespace {

/// The style of an estimate; patterns and widths tell estimates apart without colours.
struct EstimateStyle {
  Color color;
  LinePattern pattern;
  double width;
};

const EstimateStyle& style_of(std::size_t index) {
  static constexpr std::array kStyles = {EstimateStyle{kBlue, LinePattern::kSolid, 2.8},
                                         EstimateStyle{kVermilion, LinePattern::kSolid, 1.4},
                                         EstimateStyle{kGreen, LinePattern::kDashed, 2},
                                         EstimateStyle{kPurple, LinePattern::kDashDotted, 2},
                                         EstimateStyle{kBlack, LinePattern::kDotted, 2},
                                         EstimateStyle{kOrange, LinePattern::kDashed, 1.4}};
  return kStyles.at(index % kStyles.size());
}

template <typename Value>
std::vector<double> sorted_values(const std::vector<PoseError>& errors, const Value& value) {
  std::vector<double> values;
  for (const PoseError& error : errors) {
    if (std::isfinite(value(error))) values.push_back(value(error));
  }
  std::sort(values.begin(), values.end());
  return values;
}

/// Returns a quantile of sorted values; 0 if there are none.
double quantile(const std::vector<double>& values, double share) {
  if (values.empty()) return 0;
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
  return values[std::max<std::size_t>(rank, 1) - 1];
}

/// Returns the end of the error axis. An estimate that is several times worse than the best one
/// must not press all others against the left edge.
double end_of_axis(const std::vector<std::vector<double>>& estimates) {
  constexpr double kShown = 0.95;
  constexpr double kTimesTheBest = 4;
  double best = std::numeric_limits<double>::infinity();
  double worst = 0;
  for (const auto& values : estimates) {
    if (values.empty()) continue;
    best = std::min(best, quantile(values, kShown));
    worst = std::max(worst, quantile(values, kShown));
  }
  return best > 0 ? std::min(worst, kTimesTheBest * best) : worst;
}

/// Returns the share of the values up to x as a staircase over x from 0 to `end`.
Series distribution(const std::vector<double>& values, double end) {
  Series series;
  const auto count = static_cast<double>(values.size());
  double share = 0;
  const auto add = [&](double x) {
    series.x.push_back(x);
    series.y.push_back(share);
  };
  add(0);
  for (std::size_t i = 0; i < values.size() && values[i] <= end; ++i) {
    add(values[i]);
    share = static_cast<double>(i + 1) / count;
    add(values[i]);
  }
  add(end);
  return series;
}

template <typename Value>
Panel distribution_panel(const std::vector<ComparedTrajectory>& estimates, std::string title,
                         std::string x_label, const Value& value) {
  std::vector<std::vector<double>> values;
  values.reserve(estimates.size());
  for (const auto& estimate : estimates) values.push_back(sorted_values(estimate.errors, value));
  const double end = end_of_axis(values);
  Panel panel{std::move(title), std::move(x_label), "share of frames", {}};
  panel.y_from_zero = true;
  for (std::size_t i = 0; i < estimates.size(); ++i) {
    if (values[i].empty()) continue;
    Series series = distribution(values[i], end);
    const EstimateStyle& style = style_of(i);
    series.label = estimates[i].name;
    series.color = style.color;
    series.pattern = style.pattern;
    series.width = style.width;
    panel.series.push_back(std::move(series));
  }
  return panel;
}

/// Returns the top view of trajectory_figure() in the colour of the estimate.
Panel top_view(const std::vector<StampedPose>& reference, const ComparedTrajectory& estimate,
               std::size_t index) {
  Panel panel = trajectory_figure(reference, estimate.poses).panels.front();
  panel.title = estimate.name;
  std::erase_if(panel.series, [](const Series& series) { return series.label == "start"; });
  for (Series& series : panel.series) {
    if (series.label != "estimate") continue;
    series.label.clear();
    series.color = style_of(index).color;
  }
  return panel;
}

}  // namespace

Figure comparison_figure(const std::vector<StampedPose>& reference,
                         const std::vector<ComparedTrajectory>& estimates) {
  Figure figure;
  const int count = std::max(1, static_cast<int>(estimates.size()));
  constexpr int kLeastWidth = 1100;
  figure.columns = 2 * count;
  figure.width = std::max(kLeastWidth, 300 * count);
  figure.height = 900;
  figure.panels.push_back(
      distribution_panel(estimates, "Translation", "error frame to frame [mm]",
                         [](const PoseError& error) { return error.translation * kMillimetres; }));
  figure.panels.push_back(distribution_panel(
      estimates, "Rotation", "error frame to frame, |log(R1 R2^T)|_F = sqrt(2) angle [deg]",
      [](const PoseError& error) { return error.rotation * kDegrees; }));
  for (auto& panel : figure.panels) panel.span = count;
  for (std::size_t i = 0; i < estimates.size(); ++i) {
    figure.panels.push_back(top_view(reference, estimates[i], i));
    figure.panels.back().span = 2;
  }
  return figure;
}

}  // namespace cvo_slam
