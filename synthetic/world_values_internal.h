// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cvo_slam/core/options.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/io/yaml_value.h"
#include "cvo_slam/synthetic/texture.h"

namespace cvo_slam::synthetic {

// The values of world files. All throw InputError with the value's line where it is another one;
// `what` is for the message.

double number_in(const YamlValue& value, const std::string& what, double low, double high);
double positive(const YamlValue& value, const std::string& what);
double not_negative(const YamlValue& value, const std::string& what);
Vector3 vector3(const YamlValue& value, const std::string& what);
/// So many positive numbers.
std::vector<double> sizes(const YamlValue& value, const std::string& what, std::size_t count);
/// Red, green and blue in [0, 1].
Color color(const YamlValue& value, const std::string& what);
std::uint32_t seed_of(const YamlValue& value);

/// Which of the keys a shape has; empty where it has none, an error where it has several.
std::string one_of(const YamlValue& value, const std::vector<std::string>& keys);

/// The value that a name stands for.
template <typename Value>
const Value& lookup(const std::vector<std::pair<std::string, Value>>& names, const YamlValue& value,
                    const std::string& what) {
  const std::string& name = value.word(what);
  std::vector<std::string> known;
  for (const auto& entry : names) {
    if (entry.first == name) return entry.second;
    known.push_back(entry.first);
  }
  value.fail(fmt::format("{}: '{}' is unknown; {}", what, name, suggestion(name, known)));
}

}  // namespace cvo_slam::synthetic
