// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include <fmt/format.h>

#include "cvo_slam/plot/ticks_internal.h"

namespace cvo_slam {
namespace {

/// The smallest 1, 2 or 5 times a power of ten that is at least `step`.
double round_up_to_nice(double step) {
  const double power = std::pow(10.0, std::floor(std::log10(step)));
  // Against the rounding of pow(): 0.2 / 0.1 must not count as more than 2.
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

}  // namespace cvo_slam
