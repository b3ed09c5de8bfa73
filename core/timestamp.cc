// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/core/timestamp.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

#include "cvo_slam/core/numbers.h"

namespace cvo_slam {
namespace {

constexpr std::array<std::int64_t, Timestamp::kMaxDecimals + 1> kPowersOfTen = {
    1, 10, 100, 1000, 10000, 100000, 1000000, 10000000, 100000000, 1000000000};
constexpr std::int64_t kNanosecondsPerSecond = 1000000000;
/// Largest seconds that can be parsed (year 2096). The difference of two stamps, shifted or not,
/// then always fits into 64 bits.
constexpr std::int64_t kMaxSeconds = 4'000'000'000;

bool is_digits(std::string_view text) {
  return text.find_first_not_of("0123456789") == std::string_view::npos;
}

/// Returns the fraction of a second behind the point in nanoseconds, rounded half up.
std::int64_t parse_fraction(std::string_view digits) {
  std::int64_t value = 0;
  for (int i = 0; i < Timestamp::kMaxDecimals; ++i) {
    const auto position = static_cast<std::size_t>(i);
    value = value * 10 + (position < digits.size() ? digits[position] - '0' : 0);
  }
  const bool round_up =
      digits.size() > Timestamp::kMaxDecimals && digits[Timestamp::kMaxDecimals] >= '5';
  return value + (round_up ? 1 : 0);
}

std::optional<Timestamp> parse_scientific(std::string_view text) {
  long double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  if (!std::isfinite(value) || std::fabs(value) > static_cast<long double>(kMaxSeconds)) {
    return std::nullopt;
  }
  return Timestamp(std::llround(value * kNanosecondsPerSecond), Timestamp::kMaxDecimals);
}

}  // namespace

std::optional<Timestamp> Timestamp::parse(std::string_view text) {
  if (text.starts_with('+')) {
    text.remove_prefix(1);
    if (text.starts_with('-')) return std::nullopt;
  }
  if (text.find_first_of("eE") != std::string_view::npos) return parse_scientific(text);
  const bool negative = !text.empty() && text.front() == '-';
  if (negative) text.remove_prefix(1);
  const std::size_t point = text.find('.');
  const std::string_view whole = text.substr(0, point);
  const std::string_view fraction =
      point == std::string_view::npos ? std::string_view() : text.substr(point + 1);
  if (whole.empty() || !is_digits(whole) || !is_digits(fraction)) return std::nullopt;

  const auto seconds = parse_integer<std::int64_t>(whole);
  if (!seconds || *seconds > kMaxSeconds) return std::nullopt;
  const std::int64_t magnitude = *seconds * kNanosecondsPerSecond + parse_fraction(fraction);
  const int decimals = static_cast<int>(std::min<std::size_t>(fraction.size(), kMaxDecimals));
  return Timestamp(negative ? -magnitude : magnitude, decimals);
}

Timestamp Timestamp::from_seconds(double seconds, int decimals) {
  return Timestamp(std::llround(seconds * static_cast<double>(kNanosecondsPerSecond)), decimals);
}

std::string Timestamp::to_string() const {
  const std::int64_t unit = kPowersOfTen[static_cast<std::size_t>(kMaxDecimals - decimals_)];
  const std::int64_t magnitude = (std::abs(nanoseconds_) + unit / 2) / unit;
  const std::int64_t per_second = kPowersOfTen[static_cast<std::size_t>(decimals_)];
  const char* sign = nanoseconds_ < 0 ? "-" : "";
  if (decimals_ == 0) return fmt::format("{}{}", sign, magnitude);
  return fmt::format("{}{}.{:0{}}", sign, magnitude / per_second, magnitude % per_second,
                     decimals_);
}

}  // namespace cvo_slam
