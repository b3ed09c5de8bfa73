// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A plot is a function that returns a Figure (trajectory_plot.h is an example); write_figure() puts
// it into files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

namespace cvo_slam {

/// A colour with 8 bits a channel.
struct Color {
  ///@{
  /// Intensity, 0 to 255.
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
  ///@}
};

///@{
/// Colours that colour-blind readers can tell apart: M. Okabe and K. Ito, "Color Universal Design",
/// 2008.
inline constexpr Color kBlack{0, 0, 0};
inline constexpr Color kOrange{230, 159, 0};
inline constexpr Color kSkyBlue{86, 180, 233};
inline constexpr Color kGreen{0, 158, 115};
inline constexpr Color kBlue{0, 114, 178};
inline constexpr Color kVermilion{213, 94, 0};
inline constexpr Color kPurple{204, 121, 167};
inline constexpr Color kGrey{153, 153, 153};
///@}

/// How a series is drawn: as a line through its points, or as the points alone.
enum class SeriesStyle { kLine, kPoints };

/// Line patterns, which tell lines apart in print without colours.
enum class LinePattern { kSolid, kDashed, kDotted, kDashDotted };

/// One curve or one set of points. A point whose x or y is not finite or is beyond 1e12 is not
/// drawn, and it interrupts the line. If x and y differ in length, the surplus of the longer one is
/// ignored. A line of a single point is drawn as a dot.
struct Series {
  std::string label;      ///< entry in the legend; a series without a label has no entry
  std::vector<double> x;  ///< positions along the x axis, in its unit
  std::vector<double> y;  ///< positions along the y axis, in its unit
  Color color = kBlue;    ///< colour of the line or of all points
  SeriesStyle style = SeriesStyle::kLine;     ///< a line, or points
  double width = 1.5;                         ///< width of the line, or radius of a point [px]
  LinePattern pattern = LinePattern::kSolid;  ///< not used for points
};

/// An image inside the axes, drawn below the series.
struct PanelImage {
  cv::Mat pixels;  ///< CV_8UC3: blue, green, red; not empty
  ///@{
  /// Position of an edge of the image on an axis; min < max.
  double x_min = 0;
  double x_max = 1;
  double y_min = 0;
  double y_max = 1;
  ///@}
};

/// Returns the image placed so that a pixel is one unit of both axes: pixel (u, v) covers x from u
/// to u + 1 and y from -v - 1 to -v.
[[nodiscard]] inline PanelImage in_pixels(const cv::Mat& pixels) {
  return {pixels, 0, static_cast<double>(pixels.cols), -static_cast<double>(pixels.rows), 0};
}

/// One pair of axes. A panel without any point shows the words "no data".
struct Panel {
  std::string title;           ///< above the axes; may be empty
  std::string x_label;         ///< with the unit
  std::string y_label;         ///< with the unit
  std::vector<Series> series;  ///< later ones are drawn over earlier ones
  bool equal_aspect = false;   ///< true if a unit is as long along x as along y
  bool y_from_zero = false;    ///< true if the y axis starts at zero, as errors need
  /// The axes end at the edges of the image. With equal_aspect, its sides keep their ratio.
  std::optional<PanelImage> image = {};
  bool scales = true;  ///< draws numbers and grid lines; without them, the panel has a frame
  int span = 1;        ///< number of columns of the figure that the panel takes, at most all
};

/// A picture of panels in rows, each row filled from the left. One legend for all panels stands
/// above them. PNG files show ASCII only: any other character becomes '?'.
struct Figure {
  std::string title;          ///< above all panels; may be empty
  std::vector<Panel> panels;  ///< from the upper left one
  int columns = 1;            ///< number of columns of panels, at least 1
  int width = 1200;           ///< [px], 100 to 4000
  int height = 800;           ///< [px], 100 to 4000
};

/// Returns the figure as SVG 1.1 text. The same figure gives the same bytes. Throws OptionError for
/// an impossible size, number of columns or image.
[[nodiscard]] std::string to_svg(const Figure& figure);

/// Returns the bytes of a PNG file of the figure's size in pixels. Throws OptionError as to_svg()
/// does.
[[nodiscard]] std::string to_png(const Figure& figure);

/// Writes the figure as `<file_stem>.png` and `<file_stem>.svg`. Throws OptionError as to_svg()
/// does, and OutputError.
void write_figure(const std::filesystem::path& file_stem, const Figure& figure);

}  // namespace cvo_slam
