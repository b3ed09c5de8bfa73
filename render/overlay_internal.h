// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "cvo_slam/render/grid_internal.h"
#include "cvo_slam/render/line_art_internal.h"

namespace cvo_slam::render {

/// An entry of the legend: a stroke in one colour or in all colours of the scale, and its meaning.
struct LegendEntry {
  std::string text;
  Color color;
  bool is_scale = false;
};

[[nodiscard]] std::vector<LegendEntry> legend_of(const MapScene& scene, const ColorScale& scale);

/// Writes texts on a picture. `unit` is the width of a thin line [px]; all sizes are multiples.
class Overlay {
 public:
  /// Image and view must outlive the object.
  Overlay(cv::Mat& image, const MapView& view, double unit)
      : image_(image), view_(view), unit_(unit) {}

  /// Draws labels beside their positions. A label that would cover an earlier one is left out, and
  /// so is one whose position is hidden. `depth` is the depth of the raster; empty = nothing hides.
  void draw(const std::vector<Label>& labels, const cv::Mat& depth = {});
  void draw_title(const std::string& title);
  void draw_legend(const std::vector<LegendEntry>& entries, const ColorScale& scale,
                   const std::string& value_label);
  /// Draws a message in the middle of the picture.
  void draw_message(const std::string& message);

 private:
  void text(cv::Point origin, const std::string& text, double size, Color color);
  [[nodiscard]] bool is_free(const cv::Rect& box) const;
  void draw_scale(cv::Point origin, int width, const ColorScale& scale,
                  const std::string& value_label);
  [[nodiscard]] int px(double units) const;
  [[nodiscard]] bool is_hidden(const Vector3& pixel, const cv::Mat& depth) const;

  cv::Mat& image_;
  const MapView& view_;
  double unit_;
  std::vector<cv::Rect> taken_;
};

}  // namespace cvo_slam::render
