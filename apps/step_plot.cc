// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/step_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace cvo_slam {
namespace {

/// Samples of a curve over t / unit; where it leaves [-limit, limit] it is broken.
template <typename Curve>
Series sampled(double begin, double end, double unit, double limit, const Curve& curve) {
  constexpr int kSamples = 80;
  Series series;
  for (int i = 0; i <= kSamples; ++i) {
    const double t = begin + (end - begin) * i / kSamples;
    const double value = curve(t);
    series.x.push_back(t / unit);
    series.y.push_back(std::abs(value) <= limit ? value : std::numeric_limits<double>::quiet_NaN());
  }
  return series;
}

/// How an expansion is drawn.
struct ExpansionStyle {
  int order;
  const char* name;
  Color color;
  LinePattern pattern;
};

constexpr std::array kExpansions = {
    ExpansionStyle{2, "2nd order", kVermilion, LinePattern::kDashed},
    ExpansionStyle{4, "4th order", kBlue, LinePattern::kSolid}};

void add_curves(const StepCurve& curve, double begin, double end, double unit,
                std::vector<Series>& series) {
  const auto exact = [&](double t) { return curve.exact(t); };
  // Expansions leave the picture where they have left the curve.
  const double limit =
      1.6 * std::max({std::abs(exact(begin)), std::abs(exact(end)), exact(curve.step(4))});
  const auto add = [&](Series line, const char* label, Color color, double width) {
    line.label = label;
    line.color = color;
    line.width = width;
    series.push_back(std::move(line));
  };
  add(sampled(begin, end, unit, limit, exact), "exact", kGrey, 5);
  for (const ExpansionStyle& style : kExpansions) {
    add(sampled(begin, end, unit, limit, [&](double t) { return curve.expanded(t, style.order); }),
        style.name, style.color, 2);
    series.back().pattern = style.pattern;
  }
}

/// The steps that the expansions choose, on the exact curve.
void add_steps(const StepCurve& curve, double unit, std::vector<Series>& series) {
  constexpr double kRadius = 6;  // [px]
  for (const ExpansionStyle& style : kExpansions) {
    const double t = curve.step(style.order);
    series.push_back({fmt::format("step of {}", style.name),
                      {t / unit},
                      {curve.exact(t)},
                      style.color,
                      SeriesStyle::kPoints,
                      kRadius});
  }
}

}  // namespace

Figure step_figure(const StepCurve& curve) {
  Figure figure;
  figure.width = 1000;
  figure.height = 620;
  figure.panels = {{}};
  Panel& panel = figure.panels[0];
  panel.title = fmt::format("Objective along a step of the gradient flow, length scale {} m",
                            curve.length_scale());
  panel.y_label = "G(t) = F(h exp(t xi)) - F(h)";
  if (!curve.has_slope()) return figure;
  const double longest = std::max(curve.step(2), curve.step(4));
  // The flow's time is far below 1: counted in a power of ten.
  const double power = std::floor(std::log10(longest));
  panel.x_label = fmt::format("t [1e{:.0f}]", power);
  add_curves(curve, -0.4 * longest, 1.6 * longest, std::pow(10, power), panel.series);
  add_steps(curve, std::pow(10, power), panel.series);
  return figure;
}

}  // namespace cvo_slam
