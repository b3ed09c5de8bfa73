// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "cvo_slam/render/color_scale_internal.h"
#include "cvo_slam/render/grid_internal.h"

namespace cvo_slam::render {

/// A line of the legend: a stroke of a colour, or of all colours of the scale, and what it means.
struct LegendEntry {
  std::string text;
  Color color;
  bool is_scale = false;
};

[[nodiscard]] std::vector<LegendEntry> legend_of(const Scene& scene, const ColorScale& scale);

/// Writes on a picture. `unit` is the width of a thin line [px]; all sizes go with it.
class Overlay {
 public:
  Overlay(cv::Mat& image, const View& view, double unit)
      : image_(image), view_(view), unit_(unit) {}

  /// Beside their places; those left out that would cover one before, and those whose places are
  /// hidden in `depth`, the raster's, where one is given.
  void draw(const std::vector<Label>& labels, const cv::Mat& depth = {});
  void draw_title(const std::string& title);
  void draw_legend(const std::vector<LegendEntry>& entries, const ColorScale& scale,
                   const std::string& value_label);
  /// In the middle of the picture.
  void draw_message(const std::string& message);

 private:
  void text(cv::Point origin, const std::string& text, double size, Color color);
  [[nodiscard]] bool is_free(const cv::Rect& box) const;
  void draw_scale(cv::Point origin, int width, const ColorScale& scale,
                  const std::string& value_label);
  [[nodiscard]] int px(double units) const;
  [[nodiscard]] bool is_hidden(const Vector3& pixel, const cv::Mat& depth) const;

  cv::Mat& image_;
  const View& view_;
  double unit_;
  std::vector<cv::Rect> taken_;
};

}  // namespace cvo_slam::render
