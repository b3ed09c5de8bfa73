// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Numbers in text, as people and other programs write them. The locale does not matter.
#pragma once

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

namespace cvo_slam {

/// Returns the number that the whole of `text` spells: "-1.5", "+0.5", "nan". A number that is too
/// small for a double is 0, one that is too large is infinite. Empty if it spells none.
[[nodiscard]] std::optional<double> parse_number(std::string_view text);

/// Returns the number that the whole of `text` spells; empty if it spells none or it is not finite.
[[nodiscard]] std::optional<double> parse_finite(std::string_view text);

/// Returns the integer that the whole of `text` spells; empty if it spells none of this type.
template <typename Integer>
[[nodiscard]] std::optional<Integer> parse_integer(std::string_view text) {
  Integer value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace cvo_slam
