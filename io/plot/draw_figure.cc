// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/io/plot/draw_figure_internal.h"
#include "cvo_slam/io/plot/ticks_internal.h"

namespace cvo_slam {
namespace {

constexpr Color kInk{51, 51, 51};
constexpr Color kGridInk{225, 225, 225};
constexpr double kTitleSize = 19;
constexpr double kPanelTitleSize = 16;
constexpr double kLabelSize = 14;
constexpr double kTickSize = 13;
constexpr double kMargin = 20;  ///< around the picture and between panels [px]
constexpr double kGap = 8;      ///< between a text and what it belongs to [px]

struct Rectangle {
  double left = 0;
  double top = 0;
  double right = 0;
  double bottom = 0;

  [[nodiscard]] double width() const { return right - left; }
  [[nodiscard]] double height() const { return bottom - top; }
};

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

/// The smallest ranges that hold all points; empty without any point.
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
  if (range.x.min > range.x.max) return std::nullopt;
  if (panel.y_from_zero) include(range.y, 0);
  return range;
}

/// Gives a range without length one, so that a single pose or a constant has its axes.
AxisRange with_length(const AxisRange& range) {
  const double magnitude = std::max(std::fabs(range.min), std::fabs(range.max));
  constexpr double kSmallest = 1e-9;  // of the magnitude: well above rounding
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

/// Draws one panel into the cell of the grid that is its own.
class PanelPainter {
 public:
  PanelPainter(const Panel& panel, const Rectangle& cell, Canvas& canvas)
      : panel_(panel), canvas_(canvas) {
    const auto data = range_of(panel);
    is_empty_ = !data;
    constexpr double kUsualNumberWidth = kTickSize * 4.6;
    set_area(cell, data, kUsualNumberWidth);
    const double needed = widest_number() + kGap;
    if (needed > kUsualNumberWidth) set_area(cell, data, needed);
  }

  void paint() {
    title_and_labels();
    grid();
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
  /// The part of the cell inside the axes, with `number_width` for the numbers on the y axis.
  void set_area(const Rectangle& cell, const std::optional<DataRange>& data, double number_width) {
    number_width_ = number_width;
    area_ = cell;
    area_.left += number_width + (panel_.y_label.empty() ? 0 : kLabelSize + kGap);
    area_.bottom -= kTickSize + kGap + (panel_.x_label.empty() ? 0 : kLabelSize + kGap);
    area_.top += panel_.title.empty() ? 0 : kPanelTitleSize + kGap;
    // A picture too small for its texts still has an area to compute with.
    area_.right = std::max(area_.right, area_.left + 1);
    area_.bottom = std::max(area_.bottom, area_.top + 1);
    if (data) axes_ = axes_of(panel_, *data, area_.width() / area_.height());
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
    canvas_.text({center, area_.bottom + 2 * kGap + kTickSize + kLabelSize * 0.75}, panel_.x_label,
                 {kLabelSize, kInk, TextAnchor::kMiddle});
    canvas_.text({area_.left - number_width_ - kGap * 0.5, (area_.top + area_.bottom) / 2},
                 panel_.y_label, {kLabelSize, kInk, TextAnchor::kMiddle, true});
  }

  void grid() {
    for (const auto& tick : x_ticks()) {
      const double x = place(tick.value, 0).x;
      canvas_.polyline({{x, area_.top}, {x, area_.bottom}}, kGridInk, 1);
      canvas_.text({x, area_.bottom + kGap + kTickSize * 0.7}, tick.label,
                   {kTickSize, kInk, TextAnchor::kMiddle});
    }
    for (const auto& tick : y_ticks()) {
      const double y = place(0, tick.value).y;
      canvas_.polyline({{area_.left, y}, {area_.right, y}}, kGridInk, 1);
      canvas_.text({area_.left - kGap * 0.75, y + kTickSize * 0.35}, tick.label,
                   {kTickSize, kInk, TextAnchor::kEnd});
    }
    canvas_.polyline(
        {{area_.left, area_.top}, {area_.left, area_.bottom}, {area_.right, area_.bottom}}, kInk,
        1);
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

  /// Leaves out what cannot be seen: a point that has hardly moved takes the last one's place.
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
    if (stroke.size() > 1) canvas_.polyline(stroke, series.color, series.width);
    stroke.clear();
  }

  const Panel& panel_;
  Canvas& canvas_;
  Rectangle area_;  ///< inside the axes [px]
  double number_width_ = 0;
  DataRange axes_;
  bool is_empty_ = false;
};

/// The first series of each label.
std::vector<const Series*> legend_entries(const Figure& figure) {
  std::vector<const Series*> entries;
  for (const auto& panel : figure.panels) {
    for (const auto& series : panel.series) {
      const bool is_known = std::any_of(entries.begin(), entries.end(), [&](const Series* entry) {
        return entry->label == series.label;
      });
      if (!series.label.empty() && !is_known) entries.push_back(&series);
    }
  }
  return entries;
}

void draw_legend(const std::vector<const Series*>& entries, double center, double baseline,
                 Canvas& canvas) {
  constexpr double kSample = 26;
  constexpr double kBetween = 26;
  double width = -kBetween;
  for (const auto* entry : entries) {
    width += kSample + kGap + text_width(entry->label, kLabelSize) + kBetween;
  }
  double x = center - width / 2;
  for (const auto* entry : entries) {
    const double y = baseline - kLabelSize * 0.35;
    if (entry->style == SeriesStyle::kPoints) {
      canvas.disc({x + kSample / 2, y}, entry->width, entry->color);
    } else {
      canvas.polyline({{x, y}, {x + kSample, y}}, entry->color, entry->width);
    }
    canvas.text({x + kSample + kGap, baseline}, entry->label, {kLabelSize, kInk});
    x += kSample + kGap + text_width(entry->label, kLabelSize) + kBetween;
  }
}

}  // namespace

void check_size(const Figure& figure) {
  constexpr int kSmallest = 100;
  constexpr int kLargest = 4000;
  const auto is_size = [](int pixels) { return pixels >= kSmallest && pixels <= kLargest; };
  if (!is_size(figure.width) || !is_size(figure.height)) {
    throw OptionError(fmt::format("figure of {}x{} px: each side must be {} to {}", figure.width,
                                  figure.height, kSmallest, kLargest));
  }
  if (figure.columns < 1) {
    throw OptionError(fmt::format("figure of {} columns: must be 1 or more", figure.columns));
  }
}

void draw_figure(const Figure& figure, Canvas& canvas) {
  check_size(figure);
  double top = kMargin;
  if (!figure.title.empty()) {
    canvas.text({figure.width / 2.0, top + kTitleSize * 0.8}, figure.title,
                {kTitleSize, kInk, TextAnchor::kMiddle});
    top += kTitleSize + kGap;
  }
  const auto entries = legend_entries(figure);
  if (!entries.empty()) {
    draw_legend(entries, figure.width / 2.0, top + kLabelSize * 0.9, canvas);
    top += kLabelSize + kMargin;
  }
  const int count = static_cast<int>(figure.panels.size());
  const int rows = (count + figure.columns - 1) / figure.columns;
  for (int i = 0; i < count; ++i) {
    const double width = (figure.width - kMargin) / static_cast<double>(figure.columns);
    const double height = (figure.height - top) / rows;
    const double left = kMargin + width * (i % figure.columns);
    const double upper = top + height * (i / figure.columns);
    const Rectangle cell{left, upper, left + width - kMargin, upper + height - kMargin};
    PanelPainter(figure.panels[static_cast<std::size_t>(i)], cell, canvas).paint();
  }
}

}  // namespace cvo_slam
