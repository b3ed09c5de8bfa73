// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/core/statistics.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace cvo_slam {
namespace {

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return (*std::max_element(values.begin(), middle) + *middle) / 2;
}

}  // namespace

Statistics summarize(std::span<const double> values) {
  Statistics result;
  if (values.empty()) return result;
  double sum = 0;
  double sum_of_squares = 0;
  for (const double value : values) {
    sum += value;
    sum_of_squares += value * value;
  }
  const auto count = static_cast<double>(values.size());
  result.count = values.size();
  result.mean = sum / count;
  result.rmse = std::sqrt(sum_of_squares / count);
  result.sse = sum_of_squares;
  // In a second pass: mean(x^2) - mean(x)^2 cancels where the errors are nearly equal.
  double squared_deviations = 0;
  for (const double value : values) {
    squared_deviations += (value - result.mean) * (value - result.mean);
  }
  result.std = std::sqrt(squared_deviations / count);
  result.median = median_of({values.begin(), values.end()});
  const auto [min, max] = std::minmax_element(values.begin(), values.end());
  result.min = *min;
  result.max = *max;
  return result;
}

Statistics in_unit(const Statistics& statistics, double factor) {
  Statistics result = statistics;
  for (double* figure :
       {&result.rmse, &result.mean, &result.median, &result.std, &result.min, &result.max}) {
    *figure *= factor;
  }
  result.sse *= factor * factor;
  return result;
}

}  // namespace cvo_slam
