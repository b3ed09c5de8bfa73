// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

namespace cvo_slam {

struct Color {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
};

/// Colours that the colour-blind tell apart: M. Okabe and K. Ito, "Color Universal Design", 2008.
inline constexpr Color kBlack{0, 0, 0};
inline constexpr Color kOrange{230, 159, 0};
inline constexpr Color kSkyBlue{86, 180, 233};
inline constexpr Color kGreen{0, 158, 115};
inline constexpr Color kBlue{0, 114, 178};
inline constexpr Color kVermilion{213, 94, 0};
inline constexpr Color kPurple{204, 121, 167};
inline constexpr Color kGrey{153, 153, 153};

enum class SeriesStyle { kLine, kPoints };

/// What tells lines apart where there are no colours.
enum class LinePattern { kSolid, kDashed, kDotted, kDashDotted };

/// One curve or cloud of points. Where x or y is not finite, or beyond 1e12, there is no point and
/// a line is broken; where one list is longer its tail is ignored. A line of one point is a dot.
struct Series {
  std::string label;  ///< its entry in the legend; series without a label have none
  std::vector<double> x;
  std::vector<double> y;
  Color color = kBlue;
  SeriesStyle style = SeriesStyle::kLine;
  double width = 1.5;  ///< of the line, or the radius of a point [px]
  LinePattern pattern = LinePattern::kSolid;
};

/// A picture inside the axes, below the series.
struct PanelImage {
  cv::Mat pixels;  ///< CV_8UC3: blue, green, red; not empty
  /// Where its edges are on the axes; min < max.
  double x_min = 0;
  double x_max = 1;
  double y_min = 0;
  double y_max = 1;
};

/// The picture with each of its pixels a unit of both axes, x to the right from 0 and y up to 0:
/// the pixel (u, v) begins at (u, -v).
[[nodiscard]] inline PanelImage in_pixels(const cv::Mat& pixels) {
  return {pixels, 0, static_cast<double>(pixels.cols), -static_cast<double>(pixels.rows), 0};
}

/// One pair of axes. Without any point it says so.
struct Panel {
  std::string title;
  std::string x_label;  ///< with the unit
  std::string y_label;  ///< with the unit
  std::vector<Series> series;
  bool equal_aspect = false;  ///< a metre is as long along x as along y
  bool y_from_zero = false;   ///< for errors: the y axis starts at zero
  /// The axes end where the picture does, and with equal_aspect its sides keep their ratio.
  std::optional<PanelImage> image = {};
  bool scales = true;  ///< numbers and lines of a grid; without them there is a frame
  int span = 1;        ///< columns of the figure that it takes, at most all
};

/// A picture of panels in rows, filled from the left as far as they fit; the legend stands above
/// them, once for all. PNG knows ASCII only:
/// any other character becomes '?'.
struct Figure {
  std::string title;
  std::vector<Panel> panels;
  int columns = 1;
  int width = 1200;  ///< [px], 100 to 4000
  int height = 800;  ///< [px], 100 to 4000
};

}  // namespace cvo_slam
