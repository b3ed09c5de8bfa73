// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace cvo_slam {

/// A closed interval of an axis; min < max.
struct AxisRange {
  double min = 0;
  double max = 1;

  [[nodiscard]] double length() const { return max - min; }
};

struct Tick {
  double value = 0;
  std::string label;
};

/// The multiples of 1, 2 or 5 times a power of ten inside the range, as many of them as possible
/// but at most `max_count` (>= 2) steps; all labels with the same number of decimals.
[[nodiscard]] std::vector<Tick> make_ticks(const AxisRange& range, int max_count);

}  // namespace cvo_slam
