// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/plot/figure.h"

#include <algorithm>

#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/plot/canvas_internal.h"
#include "cvo_slam/plot/panel_internal.h"

namespace cvo_slam {
namespace {

constexpr double kTitleSize = 19;
constexpr double kMargin = 20;  // around the picture and between panels [px]

/// Returns the first series of each label.
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

/// Returns the length of the line in the legend [px]; it has to show the pattern.
double sample_width(const Series& series) {
  return series.pattern == LinePattern::kSolid ? 26 : 44;
}

double entry_width(const Series& series) {
  return sample_width(series) + kGap + text_width(series.label, kLabelSize);
}

void draw_legend(const std::vector<const Series*>& entries, double center, double baseline,
                 Canvas& canvas) {
  constexpr double kBetween = 26;
  double width = -kBetween;
  for (const auto* entry : entries) width += entry_width(*entry) + kBetween;
  double x = center - width / 2;
  for (const auto* entry : entries) {
    const double y = baseline - kLabelSize * 0.35;
    const double sample = sample_width(*entry);
    if (entry->style == SeriesStyle::kPoints) {
      canvas.disc({x + sample / 2, y}, entry->width, entry->color);
    } else {
      canvas.polyline({{x, y}, {x + sample, y}}, {entry->color, entry->width, entry->pattern});
    }
    canvas.text({x + sample + kGap, baseline}, entry->label, {kLabelSize, kInk});
    x += entry_width(*entry) + kBetween;
  }
}

/// The position of a panel, counted in columns and rows of the figure.
struct GridPlace {
  int column = 0;
  int row = 0;
  int span = 1;
};

/// Returns the positions of the panels: rows filled from left to right.
std::vector<GridPlace> grid_places(const Figure& figure) {
  std::vector<GridPlace> places;
  GridPlace next;
  for (const auto& panel : figure.panels) {
    next.span = std::clamp(panel.span, 1, figure.columns);
    if (next.column + next.span > figure.columns) {
      next.column = 0;
      ++next.row;
    }
    places.push_back(next);
    next.column += next.span;
  }
  return places;
}

void check_images(const Figure& figure) {
  for (const auto& panel : figure.panels) {
    if (!panel.image) continue;
    const PanelImage& image = *panel.image;
    const bool has_extent = image.x_min < image.x_max && image.y_min < image.y_max;
    if (image.pixels.empty() || image.pixels.type() != CV_8UC3 || !has_extent) {
      throw OptionError(fmt::format(
          "panel '{}': the image must be CV_8UC3, not empty, and have an extent along both axes",
          panel.title));
    }
  }
}

/// Throws OptionError for a size, a number of columns or an image that cannot be drawn.
void check(const Figure& figure) {
  constexpr int kSmallest = 100;
  constexpr int kLargest = 4000;
  const auto is_size = [](int pixels) { return pixels >= kSmallest && pixels <= kLargest; };
  if (!is_size(figure.width) || !is_size(figure.height)) {
    throw OptionError(fmt::format("figure of {}x{} px: each side must be {} to {} px", figure.width,
                                  figure.height, kSmallest, kLargest));
  }
  if (figure.columns < 1) {
    throw OptionError(
        fmt::format("figure of {} columns: the number must be 1 or more", figure.columns));
  }
  check_images(figure);
}

/// Lays the figure out, draws it and returns the bytes of its file.
std::string draw(const Figure& figure, Canvas& canvas) {
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
  const auto places = grid_places(figure);
  const int rows = places.empty() ? 0 : places.back().row + 1;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double width = (figure.width - kMargin) / static_cast<double>(figure.columns);
    const double height = (figure.height - top) / rows;
    const double left = kMargin + width * places[i].column;
    const double upper = top + height * places[i].row;
    const CanvasRectangle cell{left, upper, left + width * places[i].span - kMargin,
                               upper + height - kMargin};
    draw_panel(figure.panels[i], cell, canvas);
  }
  return canvas.file_bytes();
}

}  // namespace

std::string to_svg(const Figure& figure) {
  check(figure);
  return draw(figure, *make_svg_canvas(figure.width, figure.height));
}

std::string to_png(const Figure& figure) {
  check(figure);
  return draw(figure, *make_png_canvas(figure.width, figure.height));
}

void write_figure(const std::filesystem::path& file_stem, const Figure& figure) {
  write_file(file_stem.string() + ".png", to_png(figure));
  write_file(file_stem.string() + ".svg", to_svg(figure));
}

}  // namespace cvo_slam
