// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace cvo_slam {

/// A point in time in integer nanoseconds. It keeps the number of decimals with which it was
/// written, so that a stamp read from a file is written back with the same digits. Comparisons
/// ignore the decimals.
class Timestamp {
 public:
  /// Largest number of decimals: those of a nanosecond.
  static constexpr int kMaxDecimals = 9;

  constexpr Timestamp() = default;
  /// `decimals` in [0, 9] is the number of digits that to_string() prints after the point.
  constexpr explicit Timestamp(std::int64_t nanoseconds, int decimals = 6)
      : nanoseconds_(nanoseconds), decimals_(decimals) {}

  /// Parses seconds in decimal ("1305031229.528748") or scientific notation, rounded to
  /// nanoseconds; a '+' in front is accepted. Returns nothing if the text is not a number between
  /// -4e9 and 4e9 (year 2096).
  static std::optional<Timestamp> parse(std::string_view text);
  /// Returns a time in seconds as a stamp, rounded to nanoseconds.
  static Timestamp from_seconds(double seconds, int decimals = 6);

  /// Returns the exact time [ns].
  [[nodiscard]] constexpr std::int64_t nanoseconds() const { return nanoseconds_; }
  /// Returns the time [s] as a double, which is exact to 0.2 us for today's stamps.
  [[nodiscard]] constexpr double seconds() const {
    return static_cast<double>(nanoseconds_) * 1e-9;
  }
  /// Returns the number of digits that to_string() prints after the point.
  [[nodiscard]] constexpr int decimals() const { return decimals_; }
  /// Returns the seconds with as many decimals as the stamp has, rounded.
  [[nodiscard]] std::string to_string() const;

  ///@{
  /// Compares the times only.
  constexpr auto operator<=>(const Timestamp& other) const {
    return nanoseconds_ <=> other.nanoseconds_;
  }
  constexpr bool operator==(const Timestamp& other) const {
    return nanoseconds_ == other.nanoseconds_;
  }
  ///@}

 private:
  std::int64_t nanoseconds_ = 0;
  int decimals_ = 6;
};

/// Returns the time from b to a, a - b, in seconds, exact to the nanosecond.
constexpr double seconds_between(const Timestamp& b, const Timestamp& a) {
  return static_cast<double>(a.nanoseconds() - b.nanoseconds()) * 1e-9;
}

}  // namespace cvo_slam
