// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cvo_slam/synthetic/world_values_internal.h"

namespace cvo_slam::synthetic {

double number_in(const YamlValue& value, const std::string& what, double low, double high) {
  const double number = value.number(what);
  if (number < low || number > high) {
    value.fail(fmt::format("{}: {} must be in [{}, {}]", what, number, low, high));
  }
  return number;
}

double positive(const YamlValue& value, const std::string& what) {
  const double number = value.number(what);
  if (number <= 0) value.fail(fmt::format("{}: {} must be positive", what, number));
  return number;
}

double not_negative(const YamlValue& value, const std::string& what) {
  const double number = value.number(what);
  if (number < 0) value.fail(fmt::format("{}: {} must not be negative", what, number));
  return number;
}

Vector3 vector3(const YamlValue& value, const std::string& what) {
  const auto numbers = value.numbers(what, 3);
  return {numbers[0], numbers[1], numbers[2]};
}

std::vector<double> sizes(const YamlValue& value, const std::string& what, std::size_t count) {
  auto numbers = value.numbers(what, count);
  for (const double number : numbers) {
    if (number <= 0) value.fail(fmt::format("{}: the size {} must be positive", what, number));
  }
  return numbers;
}

std::uint32_t seed_of(const YamlValue& value) {
  constexpr double kLargest = 4294967295.0;
  const double number = number_in(value, "seed", 0, kLargest);
  const auto seed = static_cast<std::uint32_t>(number);
  if (seed != number) value.fail(fmt::format("seed: {} must be a whole number", number));
  return seed;
}

Color color(const YamlValue& value, const std::string& what) {
  const Color result = vector3(value, what).array();
  if ((result < 0).any() || (result > 1).any()) {
    value.fail(fmt::format("{}: red, green and blue must be in [0, 1]", what));
  }
  return result;
}

std::string one_of(const YamlValue& value, const std::vector<std::string>& keys) {
  std::string found;
  for (const auto& key : keys) {
    if (value.find(key) == nullptr) continue;
    if (!found.empty()) {
      value.fail(fmt::format("shape: give one of {} and {}, not several",
                             fmt::join(keys.begin(), keys.end() - 1, ", "), keys.back()));
    }
    found = key;
  }
  return found;
}

}  // namespace cvo_slam::synthetic
