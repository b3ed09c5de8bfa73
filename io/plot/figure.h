// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

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

/// One curve or cloud of points. Where x or y is not finite, or beyond 1e12, there is no point and
/// a line is broken; where one list is longer its tail is ignored. A line of one point is a dot.
struct Series {
  std::string label;  ///< its entry in the legend; series without a label have none
  std::vector<double> x;
  std::vector<double> y;
  Color color = kBlue;
  SeriesStyle style = SeriesStyle::kLine;
  double width = 1.5;  ///< of the line, or the radius of a point [px]
};

/// One pair of axes. Without any point it says so.
struct Panel {
  std::string title;
  std::string x_label;  ///< with the unit
  std::string y_label;  ///< with the unit
  std::vector<Series> series;
  bool equal_aspect = false;  ///< a metre is as long along x as along y
  bool y_from_zero = false;   ///< for errors: the y axis starts at zero
};

/// A picture of panels in rows; the legend stands above them, once for all. PNG knows ASCII only:
/// any other character becomes '?'.
struct Figure {
  std::string title;
  std::vector<Panel> panels;
  int columns = 1;
  int width = 1200;  ///< [px], 100 to 4000
  int height = 800;  ///< [px], 100 to 4000
};

}  // namespace cvo_slam
