// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "cvo_slam/plot/panel_internal.h"

namespace cvo_slam {
namespace {

/// Returns the smallest number >= `step` that is 1, 2 or 5 times a power of ten.
double round_up_to_nice(double step) {
  const double power = std::pow(10.0, std::floor(std::log10(step)));
  // pow() rounds: 0.2 / 0.1 must not count as more than 2.
  constexpr double kSlack = 1 + 1e-9;
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power * kSlack >= step) return factor * power;
  }
  return 10 * power;
}

std::string format_label(double value, double step, const AxisRange& range) {
  const double largest = std::fmax(std::fabs(range.min), std::fabs(range.max));
  constexpr double kLargestPlain = 1e6;
  constexpr double kSmallestPlain = 1e-5;
  if (largest >= kLargestPlain || step < kSmallestPlain) return fmt::format("{:.6g}", value);
  const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
  return fmt::format("{:.{}f}", value, decimals);
}

constexpr Color kGridInk{225, 225, 225};
constexpr double kPanelTitleSize = 16;
constexpr double kTickSize = 13;

bool is_drawable(double value) {
  constexpr double kLargest = 1e12;
  return std::fabs(value) <= kLargest;
}

std::size_t size_of(const Series& series) { return std::min(series.x.size(), series.y.size()); }

bool has_point(const Series& series, std::size_t i) {
  return is_drawable(series.x[i]) && is_drawable(series.y[i]);
}

struct DataRange {
  AxisRange x;
  AxisRange y;
};

/// Returns the smallest ranges that hold all points; empty without any point.
std::optional<DataRange> range_of(const Panel& panel) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  DataRange range{{kInfinity, -kInfinity}, {kInfinity, -kInfinity}};
  const auto include = [](AxisRange& axis, double value) {
    axis.min = std::min(axis.min, value);
    axis.max = std::max(axis.max, value);
  };
  for (const auto& series : panel.series) {
    for (std::size_t i = 0; i < size_of(series); ++i) {
      if (!has_point(series, i)) continue;
      include(range.x, series.x[i]);
      include(range.y, series.y[i]);
    }
  }
  if (panel.image) {
    for (const double x : {panel.image->x_min, panel.image->x_max}) include(range.x, x);
    for (const double y : {panel.image->y_min, panel.image->y_max}) include(range.y, y);
  }
  if (range.x.min > range.x.max) return std::nullopt;
  if (panel.y_from_zero) include(range.y, 0);
  return range;
}

/// Returns a range of some length, so that a single pose or a constant has axes too.
AxisRange with_length(const AxisRange& range) {
  const double magnitude = std::max(std::fabs(range.min), std::fabs(range.max));
  constexpr double kSmallest = 1e-9;  // share of the magnitude: well above rounding
  if (range.length() > kSmallest * magnitude) return range;
  const double half = magnitude > 0 ? 0.1 * magnitude : 0.5;
  return {range.min - half, range.max + half};
}

AxisRange grown(const AxisRange& range, double share) {
  return {range.min - share * range.length(), range.max + share * range.length()};
}

AxisRange of_length(const AxisRange& range, double length) {
  const double middle = (range.min + range.max) / 2;
  return {middle - length / 2, middle + length / 2};
}

DataRange axes_of(const Panel& panel, const DataRange& data, double aspect) {
  if (panel.image) return data;
  constexpr double kAir = 0.05;
  if (panel.equal_aspect) {
    const double extent = std::max(data.x.length(), data.y.length() * aspect);
    const double magnitude = std::max({std::fabs(data.x.min), std::fabs(data.x.max),
                                       std::fabs(data.y.min), std::fabs(data.y.max)});
    const double length = extent > 1e-9 * magnitude ? (1 + 2 * kAir) * extent : 1 + 0.1 * magnitude;
    return {of_length(data.x, length), of_length(data.y, length / aspect)};
  }
  DataRange axes{with_length(data.x), grown(with_length(data.y), kAir)};
  if (panel.y_from_zero) axes.y.min = std::min(0.0, data.y.min);
  return axes;
}

/// Draws one panel into its cell.
class PanelPainter {
 public:
  PanelPainter(const Panel& panel, const CanvasRectangle& cell, Canvas& canvas)
      : panel_(panel), canvas_(canvas) {
    const auto data = range_of(panel);
    is_empty_ = !data;
    constexpr double kUsualNumberWidth = kTickSize * 4.6;
    set_area(cell, data, panel.scales ? kUsualNumberWidth : 0);
    const double needed = widest_number() + kGap;
    if (panel.scales && needed > kUsualNumberWidth) set_area(cell, data, needed);
  }

  void paint() {
    title_and_labels();
    if (panel_.image) picture();
    if (panel_.scales) {
      grid();
    } else {
      frame();
    }
    if (is_empty_) {
      canvas_.text({(area_.left + area_.right) / 2, (area_.top + area_.bottom) / 2}, "no data",
                   {kLabelSize, kInk, TextAnchor::kMiddle});
      return;
    }
    for (const auto& series : panel_.series) {
      if (series.style == SeriesStyle::kPoints) {
        points(series);
      } else {
        line(series);
      }
    }
  }

 private:
  /// Sets the area inside the axes, with `number_width` for the numbers on the y axis.
  void set_area(const CanvasRectangle& cell, const std::optional<DataRange>& data,
                double number_width) {
    number_width_ = number_width;
    area_ = cell;
    area_.left += number_width + (panel_.y_label.empty() ? 0 : kLabelSize + kGap);
    area_.bottom -= number_height() + (panel_.x_label.empty() ? 0 : kLabelSize + kGap);
    area_.top += panel_.title.empty() ? 0 : kPanelTitleSize + kGap;
    // A figure that is too small for its texts still needs an area to compute with.
    area_.right = std::max(area_.right, area_.left + 1);
    area_.bottom = std::max(area_.bottom, area_.top + 1);
    if (data && panel_.image && panel_.equal_aspect) fit_area(*data);
    if (data) axes_ = axes_of(panel_, *data, area_.width() / area_.height());
  }

  /// Returns the height of the numbers below the x axis [px].
  [[nodiscard]] double number_height() const { return panel_.scales ? kTickSize + kGap : 0; }

  /// Cuts the area to the proportions of the data; its middle stays.
  void fit_area(const DataRange& data) {
    const double scale =
        std::min(area_.width() / data.x.length(), area_.height() / data.y.length());
    const double spare_width = area_.width() - scale * data.x.length();
    const double spare_height = area_.height() - scale * data.y.length();
    area_ = {area_.left + spare_width / 2, area_.top + spare_height / 2,
             area_.right - spare_width / 2, area_.bottom - spare_height / 2};
  }

  [[nodiscard]] double widest_number() const {
    double widest = 0;
    for (const auto& tick : y_ticks()) {
      widest = std::max(widest, text_width(tick.label, kTickSize));
    }
    return widest;
  }

  [[nodiscard]] std::vector<Tick> x_ticks() const {
    return make_ticks(axes_.x, steps(area_.width(), panel_.equal_aspect ? 60 : 75));
  }

  [[nodiscard]] std::vector<Tick> y_ticks() const {
    return make_ticks(axes_.y, steps(area_.height(), panel_.equal_aspect ? 60 : 45));
  }

  static int steps(double pixels, double per_step) {
    return std::max(2, static_cast<int>(pixels / per_step));
  }

  [[nodiscard]] CanvasPoint place(double x, double y) const {
    return {area_.left + (x - axes_.x.min) / axes_.x.length() * area_.width(),
            area_.bottom - (y - axes_.y.min) / axes_.y.length() * area_.height()};
  }

  void title_and_labels() {
    const double center = (area_.left + area_.right) / 2;
    canvas_.text({center, area_.top - kGap}, panel_.title,
                 {kPanelTitleSize, kInk, TextAnchor::kMiddle});
    canvas_.text({center, area_.bottom + number_height() + kGap + kLabelSize * 0.75},
                 panel_.x_label, {kLabelSize, kInk, TextAnchor::kMiddle});
    canvas_.text({area_.left - number_width_ - kGap * 0.5, (area_.top + area_.bottom) / 2},
                 panel_.y_label, {kLabelSize, kInk, TextAnchor::kMiddle, true});
  }

  void grid() {
    for (const auto& tick : x_ticks()) {
      const double x = place(tick.value, 0).x;
      canvas_.polyline({{x, area_.top}, {x, area_.bottom}}, {kGridInk});
      canvas_.text({x, area_.bottom + kGap + kTickSize * 0.7}, tick.label,
                   {kTickSize, kInk, TextAnchor::kMiddle});
    }
    for (const auto& tick : y_ticks()) {
      const double y = place(0, tick.value).y;
      canvas_.polyline({{area_.left, y}, {area_.right, y}}, {kGridInk});
      canvas_.text({area_.left - kGap * 0.75, y + kTickSize * 0.35}, tick.label,
                   {kTickSize, kInk, TextAnchor::kEnd});
    }
    canvas_.polyline(
        {{area_.left, area_.top}, {area_.left, area_.bottom}, {area_.right, area_.bottom}}, {kInk});
  }

  void frame() {
    canvas_.polyline({{area_.left, area_.top},
                      {area_.left, area_.bottom},
                      {area_.right, area_.bottom},
                      {area_.right, area_.top},
                      {area_.left, area_.top}},
                     {kInk});
  }

  void picture() {
    const PanelImage& image = *panel_.image;
    const CanvasPoint upper_left = place(image.x_min, image.y_max);
    const CanvasPoint lower_right = place(image.x_max, image.y_min);
    canvas_.image({upper_left.x, upper_left.y, lower_right.x, lower_right.y}, image.pixels);
  }

  void points(const Series& series) {
    for (std::size_t i = 0; i < size_of(series); ++i) {
      if (has_point(series, i)) {
        canvas_.disc(place(series.x[i], series.y[i]), series.width, series.color);
      }
    }
  }

  void line(const Series& series) {
    std::vector<CanvasPoint> stroke;
    for (std::size_t i = 0; i < size_of(series); ++i) {
      if (has_point(series, i)) {
        extend(stroke, place(series.x[i], series.y[i]));
      } else {
        flush(stroke, series);
      }
    }
    flush(stroke, series);
  }

  /// Adds a point to a stroke. Leaves out what cannot be seen: a point that is very near to the
  /// one before the last replaces the last one.
  static void extend(std::vector<CanvasPoint>& stroke, const CanvasPoint& point) {
    constexpr double kVisible = 0.3;
    const std::size_t count = stroke.size();
    if (count >= 2 &&
        std::hypot(point.x - stroke[count - 2].x, point.y - stroke[count - 2].y) < kVisible) {
      stroke.back() = point;
    } else {
      stroke.push_back(point);
    }
  }

  void flush(std::vector<CanvasPoint>& stroke, const Series& series) {
    if (stroke.size() == 1)
      canvas_.disc(stroke.front(), std::max(2.0, series.width / 2), series.color);
    if (stroke.size() > 1) canvas_.polyline(stroke, {series.color, series.width, series.pattern});
    stroke.clear();
  }

  const Panel& panel_;
  Canvas& canvas_;
  CanvasRectangle area_;  // inside the axes [px]
  double number_width_ = 0;
  DataRange axes_;
  bool is_empty_ = false;
};

}  // namespace

std::vector<Tick> make_ticks(const AxisRange& range, int max_count) {
  const double step = round_up_to_nice(range.length() / max_count);
  const double slack = 1e-9 * range.length();
  const double first = std::ceil((range.min - slack) / step);
  std::vector<Tick> ticks;
  for (int i = 0; i <= max_count + 1; ++i) {
    // + 0.0 makes a negative zero positive.
    const double value = (first + i) * step + 0.0;
    if (value > range.max + slack) break;
    ticks.push_back({value, format_label(value, step, range)});
  }
  return ticks;
}

void draw_panel(const Panel& panel, const CanvasRectangle& cell, Canvas& canvas) {
  PanelPainter(panel, cell, canvas).paint();
}

}  // namespace cvo_slam
