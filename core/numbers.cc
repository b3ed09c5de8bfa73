// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/core/numbers.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cvo_slam {
namespace {

/// Returns the power of ten of the first digit that is not zero: 0 for "1.5", 399 for "1e399";
/// a very low one if all digits are zero.
long decimal_magnitude(std::string_view number) {
  const std::size_t e = number.find_first_of("eE");
  const std::string_view digits = number.substr(0, e);
  const std::size_t point = std::min(digits.find('.'), digits.size());
  const std::size_t first = digits.find_first_of("123456789");
  if (first == std::string_view::npos) return std::numeric_limits<int>::min();
  const long place = static_cast<long>(point) - static_cast<long>(first) - (first < point ? 1 : 0);
  if (e == std::string_view::npos) return place;
  std::string_view exponent_text = number.substr(e + 1);
  if (exponent_text.starts_with('+')) exponent_text.remove_prefix(1);
  const auto exponent = parse_integer<int>(exponent_text);  // empty if it is beyond an int
  if (exponent) return place + *exponent;
  return exponent_text.starts_with('-') ? std::numeric_limits<int>::min()
                                        : std::numeric_limits<int>::max();
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  const bool plus = text.starts_with('+');
  if (plus) text.remove_prefix(1);
  if (plus && text.starts_with('-')) return std::nullopt;
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end != text.data() + text.size() || text.empty()) return std::nullopt;
  if (error == std::errc()) return value;
  if (error != std::errc::result_out_of_range) return std::nullopt;
  const bool negative = text.starts_with('-');
  if (negative) text.remove_prefix(1);
  const double limit = decimal_magnitude(text) < 0 ? 0.0 : std::numeric_limits<double>::infinity();
  return negative ? -limit : limit;
}

std::optional<double> parse_finite(std::string_view text) {
  const auto value = parse_number(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

}  // namespace cvo_slam
