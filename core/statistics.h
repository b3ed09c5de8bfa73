// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>
#include <span>

namespace cvo_slam {

/// What is usually reported of a list of errors, in the unit of the errors (sse: its square).
/// Without any value (count = 0) all figures are NaN.
struct Statistics {
  std::size_t count = 0;
  double rmse = std::numeric_limits<double>::quiet_NaN();
  double mean = std::numeric_limits<double>::quiet_NaN();
  double median =
      std::numeric_limits<double>::quiet_NaN();  ///< of an even count: the middle two's mean
  double std = std::numeric_limits<double>::quiet_NaN();  ///< of the population: divided by count
  double min = std::numeric_limits<double>::quiet_NaN();
  double max = std::numeric_limits<double>::quiet_NaN();
  double sse = std::numeric_limits<double>::quiet_NaN();  ///< sum of squared errors
};

/// The statistics of `values`, which must not contain NaN.
[[nodiscard]] Statistics summarize(std::span<const double> values);

/// The same statistics in another unit: `factor` is the size of the old unit in the new one.
[[nodiscard]] Statistics in_unit(const Statistics& statistics, double factor);

}  // namespace cvo_slam
