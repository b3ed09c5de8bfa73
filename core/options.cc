// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/core/options.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <type_traits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/numbers.h"

namespace cvo_slam {
namespace {

/// Prefix of the keys of expert options.
constexpr std::string_view kExpert = "expert.";

bool is_expert(std::string_view key) { return key.starts_with(kExpert); }

std::string_view trim(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

template <typename T>
std::optional<T> parse_value(std::string_view text) {
  if constexpr (std::is_floating_point_v<T>) {
    return parse_number(trim(text));
  } else {
    return parse_integer<T>(trim(text));
  }
}

template <typename T>
std::string describe_range(const Range<T>& range) {
  const bool has_min = range.min > std::numeric_limits<T>::lowest();
  const bool has_max = range.max < std::numeric_limits<T>::max();
  if (has_min && has_max) return fmt::format("{} to {}", range.min, range.max);
  if (has_min) return fmt::format("at least {}", range.min);
  if (has_max) return fmt::format("at most {}", range.max);
  return "any number";
}

[[noreturn]] void fail(const std::string& key, std::string_view text, const std::string& allowed) {
  throw OptionError(fmt::format("{}={}: the value must be {}", key, trim(text), allowed));
}

template <typename T>
T parse_in_range(const std::string& key, std::string_view text, const Range<T>& range) {
  const auto value = parse_value<T>(text);
  // Written so that NaN fails.
  if (!value || !(*value >= range.min && *value <= range.max))
    fail(key, text, describe_range(range));
  return *value;
}

template <typename T>
std::string describe_list(const Range<T>& range) {
  return fmt::format("a list [a, b, ...] of values {}", describe_range(range));
}

template <typename T>
std::vector<T> parse_list(const std::string& key, std::string_view text, const Range<T>& range) {
  const std::string allowed = describe_list(range);
  std::string_view rest = trim(text);
  if (rest.size() < 2 || rest.front() != '[' || rest.back() != ']') fail(key, text, allowed);
  rest = rest.substr(1, rest.size() - 2);
  std::vector<T> values;
  while (true) {
    const std::size_t comma = rest.find(',');
    values.push_back(parse_in_range(key, rest.substr(0, comma), range));
    if (comma == std::string_view::npos) return values;
    rest.remove_prefix(comma + 1);
  }
}

template <typename T>
Option list_option(const std::string& key, std::vector<T>& value, const Range<T>& range,
                   std::string unit, std::string doc) {
  const auto set = [&value, key, range](std::string_view text) {
    value = parse_list(key, text, range);
  };
  const auto get = [&value] { return fmt::format("[{}]", fmt::join(value, ", ")); };
  return {key, std::move(unit), describe_list(range), std::move(doc), get, set};
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substitute = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substitute});
    }
  }
  return row[b.size()];
}

/// Returns the candidate with the smallest edit distance to `word`; an empty text if there is none,
/// or if even that one differs in so many letters that `word` is no misspelling of it.
std::string nearest_name(std::string_view word, const std::vector<std::string>& candidates) {
  std::size_t best = (word.size() + 1) / 2 + 1;
  std::string nearest;
  for (const auto& candidate : candidates) {
    const std::size_t distance = edit_distance(word, candidate);
    if (distance >= best) continue;
    best = distance;
    nearest = candidate;
  }
  return nearest;
}

}  // namespace

std::string suggestion(std::string_view word, const std::vector<std::string>& candidates) {
  const std::string nearest = nearest_name(word, candidates);
  if (!nearest.empty()) return fmt::format("did you mean '{}'?", nearest);
  return fmt::format("there are: {}", fmt::join(candidates, ", "));
}

OptionSet& OptionSet::append(Option option) {
  if (expert_ && !is_expert(option.key)) option.key = std::string(kExpert) + option.key;
  options_.push_back(std::move(option));
  return *this;
}

OptionSet& OptionSet::expert() {
  expert_ = true;
  return *this;
}

OptionSet& OptionSet::add(const std::string& key, bool& value, std::string doc) {
  const auto set = [&value, key](std::string_view text) {
    const std::string_view word = trim(text);
    if (word != "true" && word != "false") fail(key, text, "true or false");
    value = word == "true";
  };
  return append({key, "", "true or false", std::move(doc),
                 [&value] { return std::string(value ? "true" : "false"); }, set});
}

OptionSet& OptionSet::add(const std::string& key, int& value, Range<int> range, std::string unit,
                          std::string doc) {
  const auto set = [&value, key, range](std::string_view text) {
    value = parse_in_range(key, text, range);
  };
  return append({key, std::move(unit), describe_range(range), std::move(doc),
                 [&value] { return fmt::format("{}", value); }, set});
}

OptionSet& OptionSet::add(const std::string& key, double& value, Range<double> range,
                          std::string unit, std::string doc) {
  const auto set = [&value, key, range](std::string_view text) {
    value = parse_in_range(key, text, range);
  };
  return append({key, std::move(unit), describe_range(range), std::move(doc),
                 [&value] { return fmt::format("{}", value); }, set});
}

OptionSet& OptionSet::add(const std::string& key, std::vector<int>& value, Range<int> range,
                          std::string unit, std::string doc) {
  return append(list_option(key, value, range, std::move(unit), std::move(doc)));
}

OptionSet& OptionSet::add(const std::string& key, std::vector<double>& value, Range<double> range,
                          std::string unit, std::string doc) {
  return append(list_option(key, value, range, std::move(unit), std::move(doc)));
}

OptionSet& OptionSet::add_choice(std::string key, std::vector<std::string> names,
                                 const std::function<std::size_t()>& index_of_value,
                                 const std::function<void(std::size_t)>& set_index,
                                 std::string doc) {
  const std::string allowed = fmt::format("one of {}", fmt::join(names, ", "));
  const auto get = [names, index_of_value] {
    const std::size_t i = index_of_value();
    return i < names.size() ? names[i] : std::string("(invalid)");
  };
  const auto set = [key, names, allowed, set_index](std::string_view text) {
    const auto found = std::find(names.begin(), names.end(), trim(text));
    if (found == names.end()) fail(key, text, allowed);
    set_index(static_cast<std::size_t>(found - names.begin()));
  };
  return append({std::move(key), "", allowed, std::move(doc), get, set});
}

OptionSet& OptionSet::add(const std::string& prefix, const OptionSet& nested) {
  for (Option option : nested.options_) {
    const bool expert = is_expert(option.key);
    const std::string path = expert ? option.key.substr(kExpert.size()) : option.key;
    option.key = fmt::format("{}{}.{}", expert ? kExpert : "", prefix, path);
    append(std::move(option));
  }
  return *this;
}

OptionSet& OptionSet::add(const OptionSet& other) {
  for (const Option& option : other.options_) append(option);
  return *this;
}

const Option& OptionSet::find(std::string_view key) const {
  const auto found = std::find_if(options_.begin(), options_.end(),
                                  [&](const Option& option) { return option.key == key; });
  if (found != options_.end()) return *found;
  std::vector<std::string> keys;
  for (const auto& option : options_) keys.push_back(option.key);
  // Not suggestion(): there are too many options for a line.
  const std::string nearest = nearest_name(key, keys);
  throw OptionError(fmt::format(
      "unknown option '{}'; {}", key,
      nearest.empty() ? "see --dump-config" : fmt::format("did you mean '{}'?", nearest)));
}

std::string OptionSet::get(std::string_view key) const { return find(key).get(); }

void OptionSet::set(std::string_view key, std::string_view text) const {
  const Option& option = find(key);
  try {
    option.set(text);
  } catch (const OptionError&) {
    fail(option.key, text, option.allowed);  // with the full, prefixed key
  }
}

void OptionSet::check() const {
  for (const auto& option : options_) set(option.key, option.get());
}

}  // namespace cvo_slam
