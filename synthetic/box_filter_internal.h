// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>

namespace cvo_slam::synthetic {

// Textures are sampled once a pixel. Each is therefore averaged over the footprint of the pixel in
// closed form; details that cannot be averaged so are faded out before they would alias.

/// Returns the weight of a detail of size `feature` under a filter of width `footprint` (same
/// unit): 1 if the detail spans two pixels or more (Nyquist), 0 if it spans less than one.
inline double fade(double feature, double footprint) {
  const double s = std::clamp(feature / footprint - 1, 0.0, 1.0);
  return s * s * (3 - 2 * s);
}

/// Returns std::floor() of a number in the range of std::int64_t. It is inlined, which std::floor()
/// is not on CPUs without SSE4.1.
inline double round_down(double x) {
  const auto whole = static_cast<double>(static_cast<std::int64_t>(x));
  return whole > x ? whole - 1 : whole;
}

/// Returns the share of a box of width `width` about x in which frac(x) < duty.
inline double filtered_pulse(double x, double duty, double width) {
  const auto integral = [duty](double at) {
    const double whole = round_down(at);
    return whole * duty + std::min(at - whole, duty);
  };
  return (integral(x + 0.5 * width) - integral(x - 0.5 * width)) / width;
}

/// The two unit cells that a box of width <= 1 about x touches.
struct CellSpan {
  CellSpan(double x, double width) {
    const double span = std::clamp(width, 1e-9, 1.0);
    const double low = round_down(x - 0.5 * span);
    first = static_cast<std::int32_t>(low);
    second_weight = std::clamp((x + 0.5 * span - low - 1) / span, 0.0, 1.0);
  }
  std::int32_t first = 0;
  double second_weight = 0;
};

/// Returns the average of an image of unit cells over a box of widths (width_u, width_v) <= 1 about
/// (u, v). `value(column, row)` is the value of a cell.
template <typename Value>
double filtered_cells(double u, double v, double width_u, double width_v, const Value& value) {
  const CellSpan column(u, width_u);
  const CellSpan row(v, width_v);
  const auto across = [&](std::int32_t r) {
    const double left = value(column.first, r);
    if (column.second_weight == 0) return left;
    return left + column.second_weight * (value(column.first + 1, r) - left);
  };
  const double top = across(row.first);
  if (row.second_weight == 0) return top;
  return top + row.second_weight * (across(row.first + 1) - top);
}

}  // namespace cvo_slam::synthetic
